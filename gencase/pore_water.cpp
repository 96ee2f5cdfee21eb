#include "gencase/pore_water.hpp"

#include <algorithm>

#include "common/particle_arrays.hpp"
#include "gencase/hydrostatic.hpp"
#include "physics/seepage/skeleton.hpp"

namespace thalweg::gencase {
namespace {

/// Appends a copy of particle i under a new id and returns its index.
std::size_t duplicate(ParticleSet& set, std::size_t i) {
  const auto copy = [i](auto& values) {
    if (values.empty()) return;
    const auto value = values[i];
    values.push_back(value);
  };
  const std::size_t index = set.size();
  for_each_array(set, [&](const char*, auto& values) { copy(values); });
  copy(set.position);
  for (auto& [name, values] : set.scalars) copy(values);
  for (auto& [name, values] : set.doubles) copy(values);
  set.id[index] = static_cast<std::int64_t>(index);
  return index;
}

}  // namespace

std::size_t split_into_mixture(const Case& scene, const std::vector<PlacedShape>& shapes, const Filling& filling,
                               double gravity, double sound_speed, ParticleSet& particles) {
  const SedimentParameters& bed = scene.sediment();
  const double rho_w = scene.water.density;
  const double solids = 1 - bed.porosity;
  const double cell = filling.lattice.cell();
  std::vector<PlacedShape> of_water = shapes;
  for (PlacedShape& shape : of_water)
    if (shape.is_fluid()) shape.density_at_rest = shape.weighing_density = rho_w;
  const HydrostaticStart water(filling, of_water, gravity);

  const std::size_t before = particles.size();
  std::vector<double> pressures(static_cast<std::size_t>(filling.lattice.column_length()));
  std::size_t i = 0;
  for (std::int64_t column = 0; column < filling.lattice.columns(); ++column) {
    water.column(column, pressures);
    for (std::size_t along = 0; along < pressures.size(); ++along) {
      const auto node = static_cast<std::size_t>(column) * pressures.size() + along;
      const Label label = filling.label[node];
      if (label == nothing || label == solid_core) continue;
      const std::size_t grain = i++;
      if (!shapes[label - 1U].is_fluid()) continue;
      const double pressure = pressures[along];
      const double density = hydrostatic_density(rho_w, pressure, sound_speed);
      const bool is_bed = shapes[label - 1U].shape->role == ShapeRole::sediment;
      if (is_bed) {
        // The packing carries what the bed as one fluid carried beyond the pressure of its water.
        const double load = std::max(0.0, static_cast<double>(particles.pressure[grain]) - pressure);
        const double stiffness = skeleton_stiffness(solids, bed.grain_density, rho_w, sound_speed);
        particles.density[grain] = static_cast<float>(solids * bed.grain_density * (1 + load / stiffness));
        particles.mass[grain] = static_cast<float>(solids * bed.grain_density * cell);
        particles.pressure[grain] = static_cast<float>(pressure);
      }
      const std::size_t wet = is_bed ? duplicate(particles, grain) : grain;
      particles.type[wet] = ParticleType::water;
      if (!particles.state.empty()) particles.state[wet] = SedimentState::none;
      particles.density[wet] = static_cast<float>(density);
      particles.mass[wet] = static_cast<float>(density * cell * (is_bed ? bed.porosity : 1));
      particles.pressure[wet] = static_cast<float>(pressure);
    }
  }
  return particles.size() - before;
}

}  // namespace thalweg::gencase
