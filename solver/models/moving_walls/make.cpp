#include <fmt/format.h>

#include "common/error.hpp"
#include "solver/models/all.hpp"
#include "solver/models/make.hpp"

namespace thalweg {

namespace {

/// True if walls move. Throws InputError where a moving wall's motion is not known.
bool has_moving_walls(const Case& of, const ParticleSet& particles) {
  if (count_by_type(particles)[static_cast<std::size_t>(ParticleType::moving_wall)] == 0) return false;
  const auto numbers = particles.scalars.find(motion_array);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles.type[i] != ParticleType::moving_wall) continue;
    const float number = numbers == particles.scalars.end() ? 0 : numbers->second[i];
    if (number >= 1 && number <= static_cast<float>(of.motions.size())) continue;
    throw InputError(
        fmt::format("{}: moving wall particle {} has the motion {:g} in the array Motion, and the case has "
                    "{}; fill the scene again with gencase",
                    of.file.string(), particles.id[i], number, of.motions.size()));
  }
  return true;
}

}  // namespace

template <int Dim>
void MovingWallsModel::make(const SceneSource& from, Scene<Dim>& scene) {
  scene.has_moving_walls = has_moving_walls(from.of, from.particles);
  scene.walls_move = scene.walls_move || scene.has_moving_walls;
}

template void MovingWallsModel::make(const SceneSource&, Scene<2>&);
template void MovingWallsModel::make(const SceneSource&, Scene<3>&);

}  // namespace thalweg
