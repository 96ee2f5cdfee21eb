#include "gencase/particle_maker.hpp"

#include <algorithm>
#include <span>
#include <vector>

#include "case/reader/case_file.hpp"
#include "common/version.hpp"

namespace thalweg::gencase {
namespace {

bool is_particle(Label label) { return label != nothing && label != solid_core; }

/// Number of the shape's motion, counted from 1 in the order of the case; 0 without a motion.
float number_of_motion(const Case& scene, const Shape& shape) {
  if (shape.motion.empty()) return 0;
  const auto found = std::find_if(scene.motions.begin(), scene.motions.end(),
                                  [&](const Motion& motion) { return motion.name == shape.motion; });
  return static_cast<float>(found - scene.motions.begin() + 1);
}

}  // namespace

ParticleMaker::ParticleMaker(const Case& resolved, const std::vector<PlacedShape>& shapes, const Filling& filling,
                             const HydrostaticStart& start, double sound_speed)
    : resolved_(resolved), shapes_(shapes), filling_(filling), start_(start), sound_speed_(sound_speed) {
  has_states_ = std::any_of(shapes.begin(), shapes.end(),
                            [](const PlacedShape& shape) { return shape.shape->role == ShapeRole::sediment; });
}

Columns ParticleMaker::next_columns(std::int64_t nodes) const {
  const Lattice& lattice = filling_.lattice;
  const std::int64_t columns = std::max<std::int64_t>(1, nodes / lattice.column_length());
  return {next_column_, std::min(lattice.columns(), next_column_ + columns)};
}

std::size_t ParticleMaker::count_in(const Columns& columns) const {
  const std::int64_t length = filling_.lattice.column_length();
  const auto labels = std::span(filling_.label)
                          .subspan(static_cast<std::size_t>(columns.begin * length),
                                   static_cast<std::size_t>((columns.end - columns.begin) * length));
  return static_cast<std::size_t>(std::count_if(labels.begin(), labels.end(), is_particle));
}

ParticleSet ParticleMaker::allocate(std::size_t count) const {
  ParticleSet set;
  set.info = {resolved_.info.name,
              version(),
              hash_of(resolved_),
              resolved_.info.dimension,
              resolved_.numerics.spacing,
              resolved_.smoothing_length(),
              0,
              0};
  set.id.reserve(count);
  set.type.reserve(count);
  set.position.reserve(count);
  set.density.reserve(count);
  set.pressure.reserve(count);
  set.mass.reserve(count);
  set.velocity.assign(count, Eigen::Vector3f::Zero());
  if (has_states_) set.state.reserve(count);
  if (!filling_.walls.empty()) {
    set.normal.reserve(count);
    set.scalars["WallDistance"].reserve(count);
  }
  if (!resolved_.motions.empty()) set.scalars[motion_array].reserve(count);
  if (resolved_.has_rough_walls()) set.scalars[roughness_array].reserve(count);
  if (resolved_.has_concentration()) set.scalars[concentration_array].reserve(count);
  return set;
}

ParticleSet ParticleMaker::make(const Columns& columns) {
  ParticleSet set = allocate(count_in(columns));
  const Lattice& lattice = filling_.lattice;
  std::vector<double> pressures(static_cast<std::size_t>(lattice.column_length()));
  std::vector<float>* motions = resolved_.motions.empty() ? nullptr : &set.scalars[motion_array];
  std::vector<float>* roughness = resolved_.has_rough_walls() ? &set.scalars[roughness_array] : nullptr;
  std::vector<float>* concentration = resolved_.has_concentration() ? &set.scalars[concentration_array] : nullptr;
  std::vector<float>* distances = filling_.walls.empty() ? nullptr : &set.scalars["WallDistance"];
  for (std::int64_t column = columns.begin; column < columns.end; ++column) {
    start_.column(column, pressures);
    for (std::size_t along = 0; along < pressures.size(); ++along) {
      const std::int64_t node = column * lattice.column_length() + static_cast<std::int64_t>(along);
      const Label label = filling_.label[static_cast<std::size_t>(node)];
      if (!is_particle(label)) continue;
      const PlacedShape& shape = shapes_[label - 1U];
      const double pressure = pressures[along];
      const double density = hydrostatic_density(shape.density_at_rest, pressure, sound_speed_);
      largest_pressure_ = std::max(largest_pressure_, pressure);
      set.id.push_back(next_id_++);
      set.type.push_back(shape.type());
      set.position.push_back(lattice.position(lattice.offset(node)));
      set.density.push_back(static_cast<float>(density));
      set.pressure.push_back(static_cast<float>(pressure));
      set.mass.push_back(static_cast<float>(density * lattice.cell()));
      if (has_states_)
        set.state.push_back(shape.type() == ParticleType::sediment ? SedimentState::deposit : SedimentState::none);
      if (motions != nullptr) motions->push_back(number_of_motion(resolved_, *shape.shape));
      if (roughness != nullptr) roughness->push_back(static_cast<float>(shape.shape->roughness));
      if (concentration != nullptr) concentration->push_back(static_cast<float>(shape.shape->concentration));
      if (distances == nullptr) continue;
      const bool is_wall = shape.is_wall();
      set.normal.push_back(is_wall ? filling_.walls[next_wall_].normal : Eigen::Vector3f::Zero());
      distances->push_back(is_wall ? filling_.walls[next_wall_].distance : 0);
      if (is_wall) ++next_wall_;
    }
  }
  next_column_ = columns.end;
  return set;
}

}  // namespace thalweg::gencase
