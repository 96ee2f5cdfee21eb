#include "gencase/triangle_columns.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>

namespace thalweg::gencase {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// Side of a -> b on which the point p lies: 1 left, -1 right. A point on the line counts as moved a step to the right
/// and an infinitely smaller step upward. The sign changes with the direction of the edge, so that both triangles
/// beside it agree. 0 only if a = b.
int side(const std::array<double, 2>& a, const std::array<double, 2>& b, const std::array<double, 2>& p) {
  const auto exact =
      CGAL::orientation(Kernel::Point_2(a[0], a[1]), Kernel::Point_2(b[0], b[1]), Kernel::Point_2(p[0], p[1]));
  if (exact != CGAL::COLLINEAR) return exact == CGAL::LEFT_TURN ? 1 : -1;
  if (a[1] != b[1]) return a[1] > b[1] ? 1 : -1;
  return b[0] > a[0] ? 1 : (b[0] < a[0] ? -1 : 0);
}

constexpr int most_bins = 1024;  // in each direction

}  // namespace

TriangleColumns::TriangleColumns(const Triangles& surface, int axis)
    : surface_(surface), axis_(axis), first_((axis + 1) % 3), second_((axis + 2) % 3) {
  Place high{-HUGE_VAL, -HUGE_VAL};
  low_ = {HUGE_VAL, HUGE_VAL};
  for (const Vec3& p : surface.points)
    for (std::size_t k = 0; k < 2; ++k) {
      low_[k] = std::min(low_[k], across(p)[k]);
      high[k] = std::max(high[k], across(p)[k]);
    }
  const auto wanted = static_cast<int>(std::sqrt(static_cast<double>(surface.corners.size())));
  for (std::size_t k = 0; k < 2; ++k) {
    bins_[k] = std::clamp(wanted, 1, most_bins);
    bin_size_[k] = std::max(high[k] - low_[k], 1e-300) / bins_[k];
  }
  // Counting sort: the number of triangles of each bin, the beginning of its list, then the lists.
  const auto for_bins = [&](std::uint32_t triangle, auto&& visit) {
    Place lower{HUGE_VAL, HUGE_VAL};
    Place upper{-HUGE_VAL, -HUGE_VAL};
    for (const std::uint32_t corner : surface.corners[triangle])
      for (std::size_t k = 0; k < 2; ++k) {
        lower[k] = std::min(lower[k], across(surface.points[corner])[k]);
        upper[k] = std::max(upper[k], across(surface.points[corner])[k]);
      }
    const auto from = bin_of(lower);
    const auto to = bin_of(upper);
    for (int i = from[0]; i <= to[0]; ++i)
      for (int j = from[1]; j <= to[1]; ++j) visit(flat(i, j));
  };
  first_of_bin_.assign(static_cast<std::size_t>(bins_[0]) * bins_[1] + 1, 0);
  const auto count = static_cast<std::uint32_t>(surface.corners.size());
  for (std::uint32_t t = 0; t < count; ++t) for_bins(t, [&](std::size_t bin) { ++first_of_bin_[bin + 1]; });
  for (std::size_t bin = 1; bin < first_of_bin_.size(); ++bin) first_of_bin_[bin] += first_of_bin_[bin - 1];
  triangles_.resize(first_of_bin_.back());
  std::vector<std::uint32_t> next(first_of_bin_.begin(), first_of_bin_.end() - 1);
  for (std::uint32_t t = 0; t < count; ++t) for_bins(t, [&](std::size_t bin) { triangles_[next[bin]++] = t; });
}

std::array<int, 2> TriangleColumns::bin_of(const Place& place) const {
  std::array<int, 2> bin{};
  for (std::size_t k = 0; k < 2; ++k)
    bin[k] = static_cast<int>(std::clamp(std::floor((place[k] - low_[k]) / bin_size_[k]), 0.0, bins_[k] - 1.0));
  return bin;
}

Spans TriangleColumns::inside(const Vec3& on_line) const {
  struct Crossing {
    double at;
    int turn;  // +1 entering
  };
  const Place p = across(on_line);
  for (std::size_t k = 0; k < 2; ++k)
    if (p[k] < low_[k] || p[k] > low_[k] + bins_[k] * bin_size_[k] * (1 + 1e-12)) return {};
  const auto bin = bin_of(p);
  const std::size_t list = flat(bin[0], bin[1]);
  std::vector<Crossing> crossings;
  for (std::uint32_t entry = first_of_bin_[list]; entry < first_of_bin_[list + 1]; ++entry) {
    const auto& corners = surface_.corners[triangles_[entry]];
    const Vec3& a = surface_.points[corners[0]];
    const Vec3& b = surface_.points[corners[1]];
    const Vec3& c = surface_.points[corners[2]];
    const Place pa = across(a);
    const Place pb = across(b);
    const Place pc = across(c);
    const int turn = side(pa, pb, p);
    if (turn == 0 || side(pb, pc, p) != turn || side(pc, pa, p) != turn) continue;
    // Barycentric weights from the areas across the axis.
    const auto area = [](const Place& u, const Place& v, const Place& w) {
      return (v[0] - u[0]) * (w[1] - u[1]) - (v[1] - u[1]) * (w[0] - u[0]);
    };
    const double wa = area(pb, pc, p);
    const double wb = area(pc, pa, p);
    const double wc = area(pa, pb, p);
    const double sum = wa + wb + wc;
    if (sum == 0) continue;  // seen edge-on
    const double at = (wa * a[axis_] + wb * b[axis_] + wc * c[axis_]) / sum;
    crossings.push_back({at, -turn});  // seen from above, an outward face turns left and is left there
  }
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& s, const Crossing& t) { return s.at < t.at; });
  Spans spans;
  int winding = 0;
  for (const Crossing& crossing : crossings) {
    const int before = winding;
    winding += crossing.turn;
    if (before <= 0 && winding > 0) spans.push_back({crossing.at, crossing.at});
    if (before > 0 && winding <= 0) spans.back().high = crossing.at;
  }
  if (winding > 0 && !spans.empty()) spans.pop_back();  // an open surface; refused earlier, never trusted here
  return unite(spans, {});
}

}  // namespace thalweg::gencase
