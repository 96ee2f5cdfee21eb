#include "solver/simulation/make_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case/models/surface_bed.hpp"
#include "case/models/suspended_load.hpp"
#include "common/error.hpp"
#include "common/units.hpp"
#include "physics/water/viscosity_switch.hpp"
#include "solver/models/make.hpp"

namespace thalweg {
namespace {

template <int Dim>
Vec<Dim, double> in_dimension(const Vec3& v) {
  Vec<Dim, double> out{};
  for (int k = 0; k < Dim; ++k) out[k] = v[axis<Dim>(k)];
  return out;
}

/// Box of the domain and of all particles (walls lie around the domain's fluid), with room for rounding. Walls that
/// move are not seen beyond the domain.
template <int Dim>
void bounds(const Case& from, const ParticleSet& particles, Vec<Dim, double>& low, Vec<Dim, double>& high) {
  low = in_dimension<Dim>(from.domain.from);
  high = in_dimension<Dim>(from.domain.to);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles.type[i] == ParticleType::moving_wall) continue;
    const Vec3& x = particles.position[i];
    for (int k = 0; k < Dim; ++k) {
      low[k] = std::min(low[k], x[axis<Dim>(k)] - from.numerics.spacing);
      high[k] = std::max(high[k], x[axis<Dim>(k)] + from.numerics.spacing);
    }
  }
}

/// A node of the lattice the scene was filled on, as the particle file names it. For files that do not (of earlier
/// versions, or of other programs) it is the place of the fixed wall particle with the lowest id, which gencase names
/// too, or without fixed walls the point half a spacing inside the domain.
template <int Dim>
Vec<Dim, double> lattice_node(const Case& from, const ParticleSet& particles) {
  if (particles.info.lattice_node) return in_dimension<Dim>(*particles.info.lattice_node);
  std::size_t wall = particles.size();
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const bool first = wall == particles.size() || particles.id[i] < particles.id[wall];
    if (particles.type[i] == ParticleType::wall && first) wall = i;
  }
  if (wall < particles.size()) return in_dimension<Dim>(particles.position[wall]);
  return in_dimension<Dim>(from.domain.from + Vec3::Constant(0.5 * from.numerics.spacing));
}

/// Marks periodic directions; the box then is one period. Throws InputError for a period shorter than the lists need.
template <int Dim>
void make_periodic(const Case& from, const Scene<Dim>& s, Vec<Dim, double>& low, Vec<Dim, double>& high,
                   bool (&periodic)[Dim]) {
  for (int k = 0; k < Dim; ++k) {
    periodic[k] = from.domain.is_periodic(axis<Dim>(k));
    if (!periodic[k]) continue;
    low[k] = s.domain_from[k];
    high[k] = s.domain_to[k];
    if (high[k] - low[k] >= 2 * s.list_reach) continue;
    throw InputError(
        fmt::format("{}: domain.periodic: the period along {} ({}) is shorter than twice the neighbour "
                    "list's reach ({}); make the domain longer or the spacing smaller",
                    from.file.string(), "xyz"[axis<Dim>(k)], format_quantity(high[k] - low[k], "m"),
                    format_quantity(2 * s.list_reach, "m")));
  }
}

/// The parts of a scene that every scene has.
template <int Dim>
void make_flow(const Case& from, const ParticleSet& particles, double sound_speed, Scene<Dim>& s) {
  const Numerics& n = from.numerics;
  const double h = from.smoothing_length();
  s.spacing = n.spacing;
  s.smoothing_length = h;
  s.list_reach = 2 * h * (1 + n.list_skin);
  s.kernel = WendlandC2<Dim, float>(static_cast<float>(h));
  s.singularity = static_cast<float>(0.01 * h * h);
  s.domain_from = in_dimension<Dim>(from.domain.from);
  s.domain_to = in_dimension<Dim>(from.domain.to);
  s.lattice_node = lattice_node<Dim>(from, particles);

  Vec<Dim, double> low{};
  Vec<Dim, double> high{};
  bounds<Dim>(from, particles, low, high);
  bool periodic[Dim] = {};
  make_periodic(from, s, low, high, periodic);
  s.lattice = Lattice<Dim>(low, high, periodic, s.list_reach);

  for (int k = 0; k < Dim; ++k) s.gravity[k] = static_cast<float>(from.domain.gravity[axis<Dim>(k)]);
  s.sound_speed = static_cast<float>(sound_speed);
  s.water_density = static_cast<float>(from.water.density);
  s.water_viscosity = static_cast<float>(from.water.viscosity);
  s.sediment_density = s.water_density;
  s.diffusion = static_cast<float>(2 * n.density_diffusion * h * sound_speed);
  s.artificial_viscosity = static_cast<float>(n.artificial_viscosity * sound_speed * h);
  s.viscosity_switch = n.artificial_viscosity > 0 && n.smoothing_ratio >= least_ratio_of_viscosity_switch;
  s.acoustic_damping = static_cast<float>(n.acoustic_damper * sound_speed * h);
  s.cfl = n.cfl;
  const bool is_fluid = !models::SurfaceBedOfCase::is_on(from);  // else the bed's particles are walls
  s.has_sediment = is_fluid && (count_by_type(particles)[static_cast<std::size_t>(ParticleType::sediment)] > 0 ||
                                models::SuspendedLoadOfWater::is_on(from));
}

template <int Dim>
Scene<Dim> make(const Case& from, const ParticleSet& particles, const WaterBody* water) {
  Scene<Dim> s;
  const double sound_speed = from.numerics.sound_speed_factor * from.numerics.maximum_speed;
  make_flow(from, particles, sound_speed, s);
  const SceneSource source{from, particles, sound_speed, water};
  AllModels::each([&]<class M>() {
    if constexpr (requires { M::template make<Dim>(source, s); }) M::template make<Dim>(source, s);
  });
  return s;
}

}  // namespace

AnyScene make_scene(const Case& from, const ParticleSet& particles, const WaterBody* water) {
  if (!(from.numerics.maximum_speed > 0)) {
    throw InputError(from.file.string() +
                     ": numerics.maximum_speed is not resolved; fill the scene again with gencase");
  }
  if (from.info.dimension == 3) return make<3>(from, particles, water);
  return make<2>(from, particles, water);
}

}  // namespace thalweg
