#include "case/bed_on_ground.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "case/models/surface_bed.hpp"
#include "common/error.hpp"

namespace thalweg {

void require_bed_on_ground(const Case& of, const ParticleSet& particles) {
  if (!models::SurfaceBedOfCase::is_on(of)) return;
  const double spacing = of.numerics.spacing;
  const bool in_space = of.info.dimension == 3;
  const Vec3 first = particles.size() > 0 ? particles.position.front() : Vec3(Vec3::Zero());
  const Vec3 node = particles.info.lattice_node.value_or(first);
  using Place = std::array<long long, 2>;
  std::map<Place, std::vector<std::size_t>> stacks;  // fluid over each place of the ground
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles.type[i] != ParticleType::water && particles.type[i] != ParticleType::sediment) continue;
    const Vec3 at = (particles.position[i] - node) / spacing;
    stacks[{std::llround(at.x()), in_space ? std::llround(at.y()) : 0}].push_back(i);
  }
  for (auto& [place, stack] : stacks) {
    std::sort(stack.begin(), stack.end(),
              [&](std::size_t a, std::size_t b) { return particles.position[a].z() < particles.position[b].z(); });
    const double lowest = particles.position[stack.front()].z();
    std::size_t layers = 0;
    for (const std::size_t i : stack) {
      if (particles.type[i] != ParticleType::sediment) continue;
      const Vec3& x = particles.position[i];
      if (std::abs(x.z() - lowest - static_cast<double>(layers) * spacing) > 0.5 * spacing) {
        throw InputError(
            fmt::format("{}: the sediment at x = {:.4g} m, z = {:.4g} m hangs over water or a wall, and sediment = "
                        "\"surface\" is one bed on the ground; fill it down to the ground, or write sediment = "
                        "\"three-state\"",
                        of.file.string(), x.x(), x.z()));
      }
      ++layers;
    }
  }
}

}  // namespace thalweg
