#pragma once

#include <cstdint>
#include <vector>

#include "common/particles.hpp"

namespace thalweg::gencase {

/// A line of lattice nodes parallel to a coordinate axis.
struct Line {
  Vec3 origin = Vec3::Zero();  // [m]; its entry along `axis` is not used
  int axis = 2;
  double first = 0;  // [m] first node along the axis
  double step = 0;   // [m] from one node to the next
  std::int64_t count = 0;

  [[nodiscard]] double along(std::int64_t node) const { return first + static_cast<double>(node) * step; }
  [[nodiscard]] Vec3 point(double at) const {
    Vec3 result = origin;
    result[axis] = at;
    return result;
  }
};

/// A part of a line, ends included [m].
struct Span {
  double low;
  double high;
};

/// Disjoint parts of one line in ascending order.
using Spans = std::vector<Span>;

/// The parts in `a` or `b`, in `a` and `b`, in `a` and not in `b`.
Spans unite(const Spans& a, const Spans& b);
Spans intersect(const Spans& a, const Spans& b);
Spans subtract(const Spans& a, const Spans& b);

/// True if `at` [m] lies in one of the spans, ends included.
bool covers(const Spans& spans, double at);

/// Calls `visit(first, last)` for every run of nodes of `line` within `spans`, last included.
template <class Visit>
void for_runs(const Line& line, const Spans& spans, Visit&& visit);

/// Index of the first node at or above `at` [m], from 0 to line.count.
std::int64_t first_node_from(const Line& line, double at);

template <class Visit>
void for_runs(const Line& line, const Spans& spans, Visit&& visit) {
  for (const Span& span : spans) {
    const std::int64_t first = first_node_from(line, span.low);
    std::int64_t end = first_node_from(line, span.high);
    if (end < line.count && line.along(end) <= span.high) ++end;  // ends belong to the span
    if (first < end) visit(first, end - 1);
  }
}

}  // namespace thalweg::gencase
