#include "gencase/hollows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace thalweg::gencase {
namespace {

/// Columns of free room, a spacing apart, over the walls and one further on each side.
class RoomColumns {
 public:
  RoomColumns(const Case& scene, const FlowRoom& room, const Bounds& walls, double level)
      : spacing_(scene.numerics.spacing), low_(walls.lower.z() - spacing_), level_(level) {
    const Vec3 anchor = scene.gencase.anchor == LatticeAnchor::point ? scene.gencase.anchor_point
                                                                     : scene.domain.from;  // of the lattice
    for (const int axis : {0, 1}) {
      Side& side = sides_[static_cast<std::size_t>(axis)];
      if (scene.info.dimension == 2 && axis == 1) continue;
      const auto& names = scene.domain.periodic;
      side.wraps = std::find(names.begin(), names.end(), axis == 0 ? "x" : "y") != names.end();
      const double from = side.wraps ? scene.domain.from[axis] : walls.lower[axis] - spacing_;
      const double to = side.wraps ? scene.domain.to[axis] : walls.upper[axis] + spacing_;
      const double first = std::floor((from - anchor[axis]) / spacing_ + (side.wraps ? 0.5 : 0));
      side.origin = anchor[axis] + (first + 0.5) * spacing_;
      side.count = std::max(1L, std::lround((to - from) / spacing_) + (side.wraps ? 0 : 1));
    }
    free_.reserve(static_cast<std::size_t>(sides_[0].count * sides_[1].count));
    for (long i = 0; i < sides_[0].count; ++i) {
      for (long j = 0; j < sides_[1].count; ++j) {
        Line line;
        line.origin = Vec3(sides_[0].at(i, spacing_), sides_[1].at(j, spacing_), 0);
        line.first = low_;
        line.step = spacing_;
        line.count = std::lround((level_ - low_) / spacing_) + 1;
        free_.push_back(below_level(room, line));
      }
    }
    keep_what_is_held();
  }

  [[nodiscard]] bool hold_something() const {
    return std::any_of(free_.begin(), free_.end(), [](const Spans& spans) { return !spans.empty(); });
  }

  /// The parts of a line along z that the walls hold.
  [[nodiscard]] Spans held(const FlowRoom& room, const Line& line) const {
    Spans result;
    for (const Span& span : below_level(room, line)) {
      if (is_held(line, span)) result.push_back(span);
    }
    return result;
  }

 private:
  struct Side {
    double origin = 0;  // [m] of the first column
    long count = 1;
    bool wraps = false;  // the domain is periodic

    [[nodiscard]] double at(long index, double spacing) const { return origin + static_cast<double>(index) * spacing; }
    /// The column that stands for an index; -1 beyond the last one.
    [[nodiscard]] long column(long index) const {
      if (wraps) return ((index % count) + count) % count;
      return index >= 0 && index < count ? index : -1;
    }
  };

  [[nodiscard]] Spans below_level(const FlowRoom& room, const Line& line) const {
    return intersect(room.cut(line), {{low_, level_}});
  }
  [[nodiscard]] Spans* column(long i, long j) {
    const long x = sides_[0].column(i);
    const long y = sides_[1].column(j);
    return x < 0 || y < 0 ? nullptr : &free_[static_cast<std::size_t>(x * sides_[1].count + y)];
  }
  static bool meet(const Span& a, const Span& b) { return std::min(a.high, b.high) > std::max(a.low, b.low); }

  /// Follows what runs out from the outermost columns, and from below all walls, and drops it.
  void keep_what_is_held() {
    struct Place {
      long i, j;
      Span span;
    };
    std::vector<Place> running;
    const auto take = [&](long i, long j, auto&& which) {
      Spans* spans = column(i, j);
      if (spans == nullptr) return;
      const auto kept = std::stable_partition(spans->begin(), spans->end(), [&](const Span& s) { return !which(s); });
      for (auto span = kept; span != spans->end(); ++span) running.push_back({i, j, *span});
      spans->erase(kept, spans->end());
    };
    for (long i = 0; i < sides_[0].count; ++i) {
      for (long j = 0; j < sides_[1].count; ++j) {
        const bool outermost = (!sides_[0].wraps && (i == 0 || i == sides_[0].count - 1)) ||
                               (sides_[1].count > 1 && !sides_[1].wraps && (j == 0 || j == sides_[1].count - 1));
        take(i, j, [&](const Span& span) { return outermost || span.low <= low_; });
      }
    }
    while (!running.empty()) {
      const Place from = running.back();
      running.pop_back();
      const auto reached = [&](const Span& span) { return meet(span, from.span); };
      take(from.i - 1, from.j, reached);
      take(from.i + 1, from.j, reached);
      take(from.i, from.j - 1, reached);
      take(from.i, from.j + 1, reached);
    }
  }

  /// A line between the columns belongs to the nearest one; beside a wall this may lie in it, and a neighbour decides.
  [[nodiscard]] bool is_held(const Line& line, const Span& span) const {
    const long i = std::lround((line.origin.x() - sides_[0].origin) / spacing_);
    const long j = sides_[1].count > 1 ? std::lround((line.origin.y() - sides_[1].origin) / spacing_) : 0;
    for (const auto& [di, dj] : {std::pair{0L, 0L}, {-1L, 0L}, {1L, 0L}, {0L, -1L}, {0L, 1L}}) {
      const Spans* spans = const_cast<RoomColumns*>(this)->column(i + di, j + dj);
      if (spans != nullptr &&
          std::any_of(spans->begin(), spans->end(), [&](const Span& held) { return meet(held, span); }))
        return true;
    }
    return false;
  }

  double spacing_;
  double low_;    // [m] below all walls
  double level_;  // [m]
  std::array<Side, 2> sides_;
  std::vector<Spans> free_;  // of each column, after keep_what_is_held() what the walls hold
};

class Hollow : public Region {
 public:
  Hollow(FlowRoom room, RoomColumns columns, Bounds bounds, double thickness)
      : room_(std::move(room)), columns_(std::move(columns)), bounds_(std::move(bounds)), thickness_(thickness) {}

  [[nodiscard]] bool contains(const Vec3& p) const override {
    Line line;
    line.origin = p;
    return covers(cut(line), p.z());
  }
  [[nodiscard]] Bounds bounds() const override { return bounds_; }
  [[nodiscard]] std::optional<double> measure() const override { return std::nullopt; }
  [[nodiscard]] std::optional<Triangles> triangles(double) const override { return std::nullopt; }
  void append_surfaces(std::vector<const Surface*>& surfaces) const override { room_.append_surfaces(surfaces); }
  [[nodiscard]] Spans cut(const Line& line) const override {
    if (line.axis != 2) return {};
    const Spans held = columns_.held(room_, line);
    if (held.empty() || thickness_ == HUGE_VAL) return held;
    const Span& lowest = held.front();
    return {{lowest.low, std::min(lowest.high, lowest.low + thickness_)}};
  }

 private:
  FlowRoom room_;
  RoomColumns columns_;
  Bounds bounds_;
  double thickness_;  // [m] of a layer; infinite for a level
};

RegionPointer make(const Case& scene, FlowRoom room, double level, double thickness) {
  Bounds box = room.bounds_of_solids();
  level = std::min(level, scene.domain.to.z());
  if (level <= box.lower.z()) return nullptr;
  RoomColumns columns(scene, room, box, level);
  if (!columns.hold_something()) return nullptr;
  box.upper.z() = level;
  return std::make_shared<Hollow>(std::move(room), std::move(columns), box, thickness);
}

}  // namespace

RegionPointer make_hollow(const Case& scene, FlowRoom room, double level) {
  return make(scene, std::move(room), level, HUGE_VAL);
}

RegionPointer make_hollow_layer(const Case& scene, FlowRoom room, double thickness) {
  const double top = room.bounds_of_solids().upper.z();
  return make(scene, std::move(room), top, thickness);
}

}  // namespace thalweg::gencase
