#include "gencase/start_flow.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "case/models/driven_flow.hpp"
#include "common/error.hpp"
#include "physics/water/log_profile.hpp"

namespace thalweg::gencase {
namespace {

/// Water in one piece along a column: nodes [bottom, top), the first of which has the number `first` among the particles.
struct WaterRun {
  std::int64_t bottom = 0;
  std::int64_t top = 0;
  std::size_t first = 0;
  double roughness = 0;  // of what it stands on [m]
  double in_column = 0;  // depth of all water over the same place, which shares the discharge [m]
};

class FlowStarter {
 public:
  FlowStarter(const Case& scene, const std::vector<PlacedShape>& shapes, ParticleSet& particles)
      : scene_(scene), shapes_(shapes), particles_(particles), component_(scene.flow.component()) {}

  /// Velocities of a run of water.
  void start(const WaterRun& run, std::span<const Label> labels) const {
    const double spacing = scene_.numerics.spacing;
    const double depth = static_cast<double>(run.top - run.bottom) * spacing;
    const double friction = friction_velocity(run, depth);
    const double mean = velocity_at(friction, depth * std::exp(-1.0), run.roughness);
    for (std::int64_t node = run.bottom; node < run.top; ++node) {
      if (!is_started(labels[static_cast<std::size_t>(node)])) continue;
      const double z = (static_cast<double>(node - run.bottom) + 0.5) * spacing;
      const double speed = scene_.flow.start == FlowStart::uniform ? mean : velocity_at(friction, z, run.roughness);
      particles_.velocity[run.first + static_cast<std::size_t>(node - run.bottom)][component_] =
          static_cast<float>(speed);
    }
  }

  [[nodiscard]] bool is_water(Label label) const {
    return label != nothing && label != solid_core && shapes_[label - 1U].shape->role == ShapeRole::water;
  }

  /// Roughness of what lies below a run [m].
  [[nodiscard]] double roughness_of(Label below) const {
    if (below == nothing || below == solid_core) return 0;
    const PlacedShape& shape = shapes_[below - 1U];
    if (shape.is_fluid()) return roughness_of_current(scene_);
    return scene_.model.wall_friction == WallFriction::rough ? shape.shape->roughness : 0;
  }

 private:
  [[nodiscard]] double viscosity() const { return scene_.water.viscosity / scene_.water.density; }

  [[nodiscard]] double velocity_at(double friction, double z, double roughness) const {
    return friction > 0 ? log_profile(friction, z, viscosity(), roughness) : 0;
  }

  [[nodiscard]] double friction_velocity(const WaterRun& run, double depth) const {
    const Flow& flow = scene_.flow;
    switch (flow.drive) {
      case Drive::off:
        break;
      case Drive::slope:
        return std::sqrt(scene_.domain.gravity.norm() * flow.slope * depth);
      case Drive::discharge:
      case Drive::velocity:
        break;
    }
    const double mean = flow.discharge > 0 ? flow.discharge / run.in_column : flow.velocity;
    return friction_velocity_of_current(mean, depth, viscosity(), run.roughness);
  }

  [[nodiscard]] bool is_started(Label label) const {
    const auto& names = scene_.flow.start_of;
    return names.empty() || std::find(names.begin(), names.end(), shapes_[label - 1U].shape->name) != names.end();
  }

  const Case& scene_;
  const std::vector<PlacedShape>& shapes_;
  ParticleSet& particles_;
  int component_;
};

}  // namespace

void Seam::look(const ParticleSet& particles) {
  if (scene_.flow.drive == Drive::off) return;
  const int axis = scene_.flow.component();
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles.type[i] != ParticleType::water) continue;
    low_ = low_ || particles.position[i][axis] < scene_.domain.from[axis] + scene_.numerics.spacing;
    high_ = high_ || particles.position[i][axis] > scene_.domain.to[axis] - scene_.numerics.spacing;
  }
}

void Seam::require_water() const {
  if (scene_.flow.drive == Drive::off || (low_ && high_)) return;
  throw InputError(scene_.file.string() + ": no water lies at both ends of the period along " + scene_.flow.along +
                   ", so that nothing can flow around it; let shapes of water reach both ends, and walls neither");
}

void start_flow(const Case& scene, const std::vector<PlacedShape>& shapes, const Filling& filling,
                const Columns& columns, ParticleSet& particles) {
  if (scene.flow.start == FlowStart::rest) return;
  const FlowStarter starter(scene, shapes, particles);
  const Lattice& lattice = filling.lattice;
  const std::int64_t length = lattice.column_length();
  std::size_t particle = 0;
  for (std::int64_t column = columns.begin; column < columns.end; ++column) {
    const std::span<const Label> labels(filling.label.data() + column * length, static_cast<std::size_t>(length));
    const auto wet = std::count_if(labels.begin(), labels.end(), [&](Label label) { return starter.is_water(label); });
    WaterRun run;
    for (std::int64_t node = 0; node < length; ++node) {
      const Label label = labels[static_cast<std::size_t>(node)];
      if (starter.is_water(label)) {
        if (run.top != node || run.top == 0) {
          run = {node, node, particle, node == 0 ? 0 : starter.roughness_of(labels[static_cast<std::size_t>(node - 1)]),
                 static_cast<double>(wet) * scene.numerics.spacing};
        }
        run.top = node + 1;
        if (node + 1 == length || !starter.is_water(labels[static_cast<std::size_t>(node + 1)])) {
          starter.start(run, labels);
        }
      }
      if (label != nothing && label != solid_core) ++particle;
    }
  }
}

}  // namespace thalweg::gencase
