#include "common/app/scour/scene_walls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "common/app/scour/body_in_plan.hpp"

namespace thalweg {
namespace {

std::string shape_name(const Shape& shape) { return fmt::format("shape \"{}\"", shape.name); }

bool is_wall(const Shape& shape) { return shape.role == ShapeRole::wall || shape.role == ShapeRole::moving_wall; }
bool is_body(const Shape& shape) { return is_wall(shape) && shape.side == WallSide::inside; }
bool is_container(const Shape& shape) {
  return is_wall(shape) && shape.kind == ShapeKind::box && shape.side == WallSide::outside;
}

/// The axis of the flow, 0 for x or 1 for y, by the drive, else by the first inlet.
int flow_axis(const Case& scene) {
  if (scene.flow.drive != Drive::off) return scene.flow.component();
  for (const Inlet& inlet : scene.inlets) {
    const Vec3 flow = inlet.axes().flow;
    if (std::abs(flow.x()) > 0.9 || std::abs(flow.y()) > 0.9) return std::abs(flow.y()) > std::abs(flow.x()) ? 1 : 0;
  }
  return 0;
}

/// Height of a shape's top; not a number where only gencase can know it.
double top_of_shape(const Case& scene, const Shape& shape) {
  switch (shape.kind) {
    case ShapeKind::box:
      return shape.to.z();
    case ShapeKind::level:
      return shape.level;
    case ShapeKind::layer:
      for (const Shape& container : scene.shapes)
        if (is_container(container)) return container.from.z() + shape.thickness;
      break;
    case ShapeKind::prism: {
      double top = -HUGE_VAL;
      if (scene.dimension() == 2 || shape.axis != Axis::z)
        for (const auto& corner : shape.polygon) top = std::max(top, corner.y());
      if (std::isfinite(top)) return top;
      break;
    }
    default:
      break;
  }
  return std::nan("");
}

/// A body's extent from below to above, and along both horizontal axes [m].
struct Extent {
  Vec3 from;
  Vec3 to;
};

bool stands_through(const Extent& body, const Level& bed) {
  const double rounding = 1e-6 * (body.to.z() - body.from.z());
  return !bed.is_known() || (body.from.z() <= bed.height + rounding && body.to.z() > bed.height + rounding);
}

/// True for kinds that may be a pier, but whose width across the flow is not read; a survey is ground, not a pier.
bool has_unread_width(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::cone:
    case ShapeKind::prism:
    case ShapeKind::mesh:
    case ShapeKind::combine_union:
    case ShapeKind::combine_difference:
    case ShapeKind::combine_intersection:
      return true;
    default:
      return false;
  }
}

bool is_upright(const Shape& cylinder) {
  const Vec3 axis = cylinder.to - cylinder.from;
  return std::abs(axis.z()) > 0.99 * axis.norm();
}

void add_pier(const Shape& shape, double width, double length, PierNose nose, SceneReading& reading) {
  for (ScourSubject& pier : reading.subjects) {
    const bool alike = pier.kind == ScourKind::pier && pier.nose == nose && pier.inputs.value("pier-width") == width &&
                       (nose == PierNose::circular || pier.inputs.value("pier-length") == length);
    if (alike) return;  // formulas know nothing of a pier's neighbours
  }
  ScourSubject pier{.kind = ScourKind::pier, .title = "pier, " + shape_name(shape), .nose = nose, .inputs = {}};
  pier.inputs.set("pier-width", width, shape_name(shape));
  if (nose != PierNose::circular) pier.inputs.set("pier-length", length, shape_name(shape));
  reading.subjects.push_back(std::move(pier));
}

void add_pipe(const Shape& shape, double center, const Level& bed, SceneReading& reading) {
  ScourSubject pipe{.kind = ScourKind::pipe, .title = "pipe, " + shape_name(shape), .nose = {}, .inputs = {}};
  pipe.inputs.set("pipe-diameter", 2 * shape.radius, shape_name(shape));
  if (bed.is_known()) pipe.inputs.set("pipe-gap", center - shape.radius - bed.height, shape_name(shape));
  reading.subjects.push_back(std::move(pipe));
}

void read_cylinder(const Case& scene, const Shape& shape, const Level& bed, SceneReading& reading) {
  if (scene.dimension() == 2) return add_pipe(shape, shape.center.z(), bed, reading);
  const Extent extent{shape.from.cwiseMin(shape.to), shape.from.cwiseMax(shape.to)};
  if (is_upright(shape)) {
    if (stands_through(extent, bed)) add_pier(shape, 2 * shape.radius, 2 * shape.radius, PierNose::circular, reading);
    return;
  }
  const Vec3 axis = (shape.to - shape.from).normalized();
  if (std::abs(axis[1 - flow_axis(scene)]) > 0.99) add_pipe(shape, 0.5 * (shape.from + shape.to).z(), bed, reading);
}

/// The flume in plan: boxes and upright prisms that stand through the bed, and the sides of what holds the water.
class Plan {
 public:
  Plan(const Case& scene, const Level& bed) : along_(flow_axis(scene)), across_(1 - along_) {
    left_ = scene.domain.from[across_];
    right_ = scene.domain.to[across_];
    for (const Shape& shape : scene.shapes) {
      if (is_container(shape)) {
        left_ = std::max(left_, shape.from[across_]);
        right_ = std::min(right_, shape.to[across_]);
      }
    }
    if (!bed.is_known()) return;  // nothing tells a pier from a step on the floor
    for (const Shape& shape : scene.shapes) {
      if (!is_body(shape)) continue;
      std::optional<BodyInPlan> body = body_in_plan(shape);
      if (body && stands_through({body->from, body->to}, bed)) bodies_.push_back(std::move(*body));
    }
  }

  [[nodiscard]] const std::vector<BodyInPlan>& bodies() const { return bodies_; }
  [[nodiscard]] double width_of(const BodyInPlan& body) const { return body.to[across_] - body.from[across_]; }
  [[nodiscard]] double length_of(const BodyInPlan& body) const { return body.to[along_] - body.from[along_]; }
  /// True if a body leaves water on both sides.
  [[nodiscard]] bool stands_free(const BodyInPlan& body) const {
    return body.from[across_] > left_ + rounding() && body.to[across_] < right_ - rounding();
  }
  /// True if a shape is a body that narrows the flume.
  [[nodiscard]] bool is_side(const Shape& shape) const {
    return std::any_of(bodies_.begin(), bodies_.end(),
                       [&](const BodyInPlan& body) { return body.shape == &shape && !stands_free(body); });
  }
  /// Width [m] between the bodies that touch a side, at a place along the flow.
  [[nodiscard]] double free_width(double place) const {
    double left = left_;
    double right = right_;
    for (const BodyInPlan& body : bodies_) {
      const auto here = body.at(along_, place);
      if (!here || stands_free(body)) continue;
      if (body.from[across_] <= left_ + rounding()) left = std::max(left, here->second);
      if (body.to[across_] >= right_ - rounding()) right = std::min(right, here->first);
    }
    return std::max(0.0, right - left);
  }
  /// Places just beside the corners of the bodies: the width is largest and smallest there.
  [[nodiscard]] std::vector<double> places(const Case& scene) const {
    std::vector<double> edges{scene.domain.from[along_], scene.domain.to[along_]};
    for (const BodyInPlan& body : bodies_)
      for (const Eigen::Vector2d& corner : body.outline) edges.push_back(corner[along_]);
    for (const Shape& shape : scene.shapes)
      if (is_container(shape)) edges.insert(edges.end(), {shape.from[along_], shape.to[along_]});
    std::sort(edges.begin(), edges.end());
    const double beside = 1e-6 * (edges.back() - edges.front());
    std::vector<double> found;
    for (std::size_t i = 1; i < edges.size(); ++i)
      if (edges[i] - edges[i - 1] > 2 * beside) found.insert(found.end(), {edges[i - 1] + beside, edges[i] - beside});
    return found;
  }

 private:
  [[nodiscard]] double rounding() const { return 1e-6 * (right_ - left_); }

  int along_;
  int across_;
  double left_ = 0;
  double right_ = 0;
  std::vector<BodyInPlan> bodies_;
};

void read_plan(const Case& scene, const Plan& plan, SceneReading& reading) {
  for (const BodyInPlan& body : plan.bodies()) {
    if (body.shape->kind != ShapeKind::box || !plan.stands_free(body)) continue;
    add_pier(*body.shape, plan.width_of(body), plan.length_of(body), PierNose::square, reading);
  }
  double widest = 0;
  double narrowest = HUGE_VAL;
  for (const double place : plan.places(scene)) {
    const double width = plan.free_width(place);
    if (!(width > 0)) continue;  // a wall across the flume: its end
    widest = std::max(widest, width);
    narrowest = std::min(narrowest, width);
  }
  if (!(narrowest < 0.999 * widest)) return;
  ScourSubject contraction{.kind = ScourKind::contraction, .title = "contraction", .nose = {}, .inputs = {}};
  contraction.inputs.set("width", widest, "walls");
  contraction.inputs.set("contracted-width", narrowest, "walls");
  reading.subjects.push_back(std::move(contraction));
}

}  // namespace

Level top_of(const Case& scene, ShapeRole role) {
  const std::string what = role == ShapeRole::water ? "water" : "bed";
  Level level{std::nan(""), fmt::format("the case has no {}", what)};
  for (const Shape& shape : scene.shapes) {
    if (shape.role != role) continue;
    const double top = top_of_shape(scene, shape);
    if (std::isnan(top)) return {top, fmt::format("the top of {} is not read", shape_name(shape))};
    if (level.is_known() && std::abs(top - level.height) > 1e-6)
      return {std::nan(""), fmt::format("the {} ends at {:g} m and at {:g} m", what, level.height, top)};
    level = {top, shape_name(shape)};
  }
  return level;
}

Level apron_before(const Case& scene, const Inlet& inlet) {
  const Vec3 flow = inlet.axes().flow;
  Eigen::Index axis = 0;
  flow.cwiseAbs().maxCoeff(&axis);
  const double sign = flow[axis] < 0 ? -1 : 1;
  Level apron{std::nan(""), ""};
  for (const Shape& shape : scene.shapes) {
    if (shape.role != ShapeRole::sediment || shape.kind != ShapeKind::box) continue;
    const double begins = sign > 0 ? shape.from[axis] : shape.to[axis];
    const double way = std::max(0.0, sign * (begins - inlet.at[axis]));
    if (!apron.is_known() || way < apron.height)
      apron = {way, fmt::format("inlet \"{}\" to {}", inlet.name, shape_name(shape))};
  }
  return apron;
}

void read_obstacles(const Case& scene, const Level& bed, SceneReading& reading) {
  const Plan plan(scene, bed);
  for (const Shape& shape : scene.shapes) {
    if (!is_body(shape)) continue;
    if (shape.kind == ShapeKind::cylinder) read_cylinder(scene, shape, bed, reading);
    if (scene.dimension() == 3 && has_unread_width(shape.kind) && !plan.is_side(shape)) {
      reading.notes.push_back({fmt::format("{} is a {}, whose width is not read; give --pier-width if it is a pier",
                                           shape_name(shape), word_for(shape.kind)),
                               "pier-width"});
    }
  }
  if (scene.dimension() == 3) read_plan(scene, plan, reading);
}

}  // namespace thalweg
