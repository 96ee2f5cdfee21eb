#include "foam_reference/start_velocity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "case/models/driven_flow.hpp"
#include "foam_reference/current.hpp"
#include "foam_reference/dictionary.hpp"
#include "foam_reference/shapes.hpp"
#include "physics/water/log_profile.hpp"

namespace thalweg::foam {
namespace {

// Water in one piece along a column of cells, [bottom, top); the cells [bottom, top) that `started` names begin to move.
struct Run {
  std::int64_t bottom = 0;
  std::int64_t top = 0;
  double roughness = 0;  // [m] of what it stands on
  std::vector<bool> started;
  bool operator==(const Run&) const = default;
};

// Columns beside each other along x that hold the same water: [from, to).
struct Stretch {
  std::int64_t from = 0;
  std::int64_t to = 0;
  std::vector<Run> runs;
  bool operator==(const Stretch&) const = default;
};

class Starter {
 public:
  explicit Starter(const FoamCase& foam_case) : foam_case_(foam_case), scene_(foam_case.scene), plan_(foam_case.plan) {}

  [[nodiscard]] std::string regions() const {
    std::string text;
    std::int64_t first = 0;
    std::vector<Stretch> stretches = row(0);
    for (std::int64_t j = 1; j <= plan_.cells[1]; ++j) {
      std::vector<Stretch> next = j < plan_.cells[1] ? row(j) : std::vector<Stretch>();
      if (j < plan_.cells[1] && next == stretches) continue;
      for (const Stretch& stretch : stretches) text += write(stretch, first, j);
      stretches = std::move(next);
      first = j;
    }
    return text;
  }

 private:
  [[nodiscard]] Vec3 corner(std::int64_t i, std::int64_t j, std::int64_t k) const {
    const Vec3 index(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
    return plan_.low + index.cwiseProduct(plan_.size());
  }

  [[nodiscard]] bool is_started(const Shape& shape) const {
    const auto& names = scene_.flow.start_of;
    return names.empty() || std::ranges::find(names, shape.name) != names.end();
  }

  [[nodiscard]] double roughness_under(const Shape* below) const {
    if (below == nullptr) return 0;
    if (below->role == ShapeRole::sediment) return roughness_of_current(scene_);
    return scene_.model.wall_friction == WallFriction::rough ? below->roughness : 0;
  }

  [[nodiscard]] std::vector<Run> column(std::int64_t i, std::int64_t j) const {
    std::vector<Run> runs;
    const Shape* below = nullptr;
    for (std::int64_t k = 0; k < plan_.cells[2]; ++k) {
      const Shape* shape = shape_at(scene_, corner(i, j, k) + 0.5 * plan_.size());
      const bool wet = shape != nullptr && shape->role == ShapeRole::water;
      if (wet && (runs.empty() || runs.back().top != k)) runs.push_back({k, k, roughness_under(below), {}});
      if (wet) {
        runs.back().top = k + 1;
        runs.back().started.push_back(is_started(*shape));
      }
      below = shape;
    }
    return runs;
  }

  [[nodiscard]] std::vector<Stretch> row(std::int64_t j) const {
    std::vector<Stretch> stretches;
    for (std::int64_t i = 0; i < plan_.cells[0]; ++i) {
      std::vector<Run> runs = column(i, j);
      if (!stretches.empty() && stretches.back().runs == runs) {
        stretches.back().to = i + 1;
      } else {
        stretches.push_back({i, i + 1, std::move(runs)});
      }
    }
    return stretches;
  }

  [[nodiscard]] Current current_over(const Run& run) const {
    const Flow& flow = scene_.flow;
    const double viscosity = kinematic_viscosity(scene_);
    Current current;
    current.depth = static_cast<double>(run.top - run.bottom) * plan_.size().z();
    if (flow.drive == Drive::slope) {
      current.friction_velocity = std::sqrt(scene_.domain.gravity.norm() * flow.slope * current.depth);
    } else {
      const double mean = flow.discharge > 0 ? flow.discharge / current.depth : flow.velocity;
      current.friction_velocity = friction_velocity_of_current(mean, current.depth, viscosity, run.roughness);
    }
    current.mean_velocity =
        log_profile(current.friction_velocity, current.depth * std::exp(-1.0), viscosity, run.roughness);
    return current;
  }

  [[nodiscard]] std::string write(const Stretch& stretch, std::int64_t first, std::int64_t last) const {
    std::string text;
    for (const Run& run : stretch.runs) {
      const Current current = current_over(run);
      for (std::int64_t k = run.bottom; k < run.top; ++k) {
        if (!run.started[static_cast<std::size_t>(k - run.bottom)]) continue;
        const double z = (static_cast<double>(k - run.bottom) + 0.5) * plan_.size().z();
        const double speed =
            scene_.flow.start == FlowStart::uniform
                ? current.mean_velocity
                : log_profile(current.friction_velocity, z, kinematic_viscosity(scene_), run.roughness);
        Vec3 velocity = Vec3::Zero();
        velocity[scene_.flow.component()] = speed;
        const EddyState eddies = eddies_at(current, z);
        const std::string turbulence = foam_case_.has_wall_functions()
                                           ? fmt::format(" volScalarFieldValue k {} volScalarFieldValue omega {}",
                                                         number(eddies.k), number(eddies.omega))
                                           : "";
        text += fmt::format(
            "    boxToCell\n    {{\n        box {} {};\n        fieldValues (volVectorFieldValue U {}{});\n    }}\n",
            vector(corner(stretch.from, first, k)), vector(corner(stretch.to, last, k + 1)), vector(velocity),
            turbulence);
      }
    }
    return text;
  }

  const FoamCase& foam_case_;
  const Case& scene_;
  const MeshPlan& plan_;
};

}  // namespace

std::string start_regions(const FoamCase& foam_case) {
  if (foam_case.scene.flow.start == FlowStart::rest) return "";
  return Starter(foam_case).regions();
}

}  // namespace thalweg::foam
