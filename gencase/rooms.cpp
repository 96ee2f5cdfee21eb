#include "gencase/rooms.hpp"

#include <algorithm>

namespace thalweg::gencase {
namespace {

/// Regions that fill a part of the room that earlier walls leave. They are never walls, so their skin is not needed.
class PartOfRoom : public Region {
 public:
  explicit PartOfRoom(FlowRoom room) : room_(std::move(room)) {}
  [[nodiscard]] bool contains(const Vec3& p) const override {
    Line line;
    line.origin = p;
    return covers(cut(line), p.z());
  }
  [[nodiscard]] std::optional<double> measure() const override { return std::nullopt; }
  [[nodiscard]] std::optional<Triangles> triangles(double) const override { return std::nullopt; }
  void append_surfaces(std::vector<const Surface*>& surfaces) const override { room_.append_surfaces(surfaces); }

 protected:
  FlowRoom room_;
};

bool beside(const Line& line, const Bounds& box) {
  for (int axis = 0; axis < 3; ++axis)
    if (axis != line.axis && (line.origin[axis] < box.lower[axis] || line.origin[axis] > box.upper[axis])) return true;
  return false;
}

class Within : public PartOfRoom {
 public:
  Within(FlowRoom room, RegionPointer region) : PartOfRoom(std::move(room)), region_(std::move(region)) {}
  [[nodiscard]] Bounds bounds() const override {
    Bounds result = region_->bounds();
    if (!room_.has_rooms()) return result;
    const Bounds rooms = room_.bounds_of_rooms();
    result.lower = result.lower.cwiseMax(rooms.lower);
    result.upper = result.upper.cwiseMin(rooms.upper).cwiseMax(result.lower);
    return result;
  }
  [[nodiscard]] Spans cut(const Line& line) const override { return intersect(region_->cut(line), room_.cut(line)); }

 private:
  RegionPointer region_;
};

class Filled : public PartOfRoom {
 public:
  Filled(FlowRoom room, Bounds box) : PartOfRoom(std::move(room)), box_(std::move(box)) {}
  [[nodiscard]] Bounds bounds() const override { return box_; }
  [[nodiscard]] Spans cut(const Line& line) const override {
    if (beside(line, box_)) return {};
    return intersect(room_.cut(line), {{box_.lower[line.axis], box_.upper[line.axis]}});
  }

 private:
  Bounds box_;
};

class Layer : public PartOfRoom {
 public:
  Layer(FlowRoom room, Bounds box, double thickness, int axis)
      : PartOfRoom(std::move(room)), box_(std::move(box)), thickness_(thickness), axis_(axis) {}
  [[nodiscard]] Bounds bounds() const override { return box_; }
  [[nodiscard]] Spans cut(const Line& line) const override {
    if (beside(line, box_) || line.axis != axis_) return {};
    const Spans free = intersect(room_.cut(line), {{box_.lower[axis_], box_.upper[axis_]}});
    if (free.empty()) return {};
    return {{free.front().low, std::min(free.front().low + thickness_, free.front().high)}};
  }

 private:
  Bounds box_;
  double thickness_;
  int axis_;
};

}  // namespace

RegionPointer make_within(FlowRoom room, RegionPointer region) {
  return std::make_shared<Within>(std::move(room), std::move(region));
}
RegionPointer make_filled(FlowRoom room, const Bounds& box) { return std::make_shared<Filled>(std::move(room), box); }
RegionPointer make_layer(FlowRoom room, const Bounds& box, double thickness, int axis) {
  return std::make_shared<Layer>(std::move(room), box, thickness, axis);
}

}  // namespace thalweg::gencase
