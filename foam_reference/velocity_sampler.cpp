#include "foam_reference/velocity_sampler.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "case/models/driven_flow.hpp"
#include "common/csv.hpp"
#include "foam_reference/current.hpp"
#include "physics/water/log_profile.hpp"

namespace thalweg::foam {
namespace {

constexpr std::array shares_of_way{0.25, 0.5, 0.75};

}  // namespace

VelocitySampler::VelocitySampler(const FoamCase& foam_case, const std::vector<Vec3>& centres)
    : foam_case_(foam_case), place_of_(centres.size(), -1), row_of_(centres.size(), 0) {
  const Case& scene = foam_case.scene;
  const MeshPlan& plan = foam_case.plan;
  component_ = scene.flow.component();
  if (!scene.inlets.empty()) {
    const Vec3 flow = scene.inlets.front().axes().flow;
    component_ = std::abs(flow.x()) >= std::abs(flow.y()) ? 0 : 1;
    sign_ = flow[component_] < 0 ? -1 : 1;
  }
  double from = plan.low[component_];
  double to = plan.high[component_];
  if (!scene.inlets.empty() && !scene.outlets.empty()) {
    const double in = scene.inlets.front().at[component_];
    const double out = scene.outlets.front().at[component_];
    from = std::min(in, out);
    to = std::max(in, out);
  }
  for (const double share : shares_of_way) {
    places_.push_back({from + share * (to - from), std::vector<Row>(static_cast<std::size_t>(plan.cells[2]))});
  }
  const double reach = std::max(4 * scene.numerics.spacing, 1.01 * plan.size()[component_]);
  for (std::size_t cell = 0; cell < centres.size(); ++cell) {
    const double row = (centres[cell].z() - plan.low.z()) / plan.size().z();
    row_of_[cell] = static_cast<std::size_t>(std::clamp(row, 0.0, static_cast<double>(plan.cells[2] - 1)));
    for (std::size_t place = 0; place < places_.size(); ++place) {
      if (std::abs(centres[cell][component_] - places_[place].at) <= reach) place_of_[cell] = static_cast<int>(place);
    }
  }
}

void VelocitySampler::add(const WaterFields& fields) {
  const double volume = foam_case_.plan.cell_volume();
  for (std::size_t cell = 0; cell < place_of_.size(); ++cell) {
    if (place_of_[cell] < 0) continue;
    Row& row = places_[static_cast<std::size_t>(place_of_[cell])].rows[row_of_[cell]];
    const double water = volume * fields.share[fields.share.size() == 1 ? 0 : cell];
    row.water += water;
    row.flow += water * sign_ * fields.velocity[fields.velocity.size() == 1 ? 0 : cell][component_];
    row.capacity += volume;
  }
}

std::vector<SampledStation> VelocitySampler::stations() const {
  const Case& scene = foam_case_.scene;
  const double dz = foam_case_.plan.size().z();
  const double viscosity = kinematic_viscosity(scene);
  const double roughness = roughness_of_current(scene);
  std::vector<SampledStation> found;
  for (const Place& place : places_) {
    const auto is_wet = [](const Row& row) { return row.capacity > 0 && row.water >= 0.5 * row.capacity; };
    const auto lowest = std::ranges::find_if(place.rows, is_wet);
    if (lowest == place.rows.end()) continue;
    SampledStation station;
    station.place = place.at;
    station.ground = foam_case_.plan.low.z() + static_cast<double>(lowest - place.rows.begin()) * dz;
    double water = 0;
    double flow = 0;
    for (auto row = lowest; row != place.rows.end(); ++row) {
      if (!(row->capacity > 0)) continue;
      station.depth += row->water / row->capacity * dz;
      water += row->water;
      flow += row->flow;
    }
    station.mean_velocity = flow / water;
    if (station.mean_velocity > 0) {
      station.friction_velocity =
          friction_velocity_of_current(station.mean_velocity, station.depth, viscosity, roughness);
    }
    for (auto row = lowest; row != place.rows.end(); ++row) {
      if (!is_wet(*row)) continue;
      const double height = (static_cast<double>(row - lowest) + 0.5) * dz;
      station.height.push_back(height);
      station.velocity.push_back(row->flow / row->water);
      station.law.push_back(
          station.friction_velocity > 0 ? log_profile(station.friction_velocity, height, viscosity, roughness) : 0);
    }
    found.push_back(std::move(station));
  }
  return found;
}

void write_stations(const std::filesystem::path& file, const std::vector<SampledStation>& stations) {
  CsvTable table({{"place", "m"},
                  {"height", "m"},
                  {"velocity", "m/s"},
                  {"law", "m/s"},
                  {"ground", "m"},
                  {"depth", "m"},
                  {"mean_velocity", "m/s"},
                  {"friction_velocity", "m/s"}});
  for (const SampledStation& station : stations) {
    for (std::size_t row = 0; row < station.height.size(); ++row) {
      table.add_row({csv_number(station.place), csv_number(station.height[row]), csv_number(station.velocity[row]),
                     csv_number(station.law[row]), csv_number(station.ground), csv_number(station.depth),
                     csv_number(station.mean_velocity), csv_number(station.friction_velocity)});
    }
  }
  table.write(file);
}

}  // namespace thalweg::foam
