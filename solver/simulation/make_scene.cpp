#include "solver/simulation/make_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/error.hpp"
#include "common/units.hpp"
#include "physics/sediment/effective_pressure.hpp"
#include "physics/sediment/material.hpp"
#include "physics/seepage/consolidation.hpp"
#include "physics/seepage/ergun.hpp"
#include "physics/seepage/skeleton.hpp"
#include "physics/transport/lift_settling.hpp"

namespace thalweg {
namespace {

template <int Dim>
Vec<Dim, double> in_dimension(const Vec3& v) {
  Vec<Dim, double> out{};
  for (int k = 0; k < Dim; ++k) out[k] = v[axis<Dim>(k)];
  return out;
}

SedimentScene make_sediment(const Case& from, double sound_speed) {
  const SedimentParameters& s = from.sediment();
  if (from.domain.gravity.x() != 0 || from.domain.gravity.y() != 0 || from.domain.gravity.z() > 0) {
    throw InputError(from.file.string() +
                     ": domain.gravity: the sediment's effective pressure is the weight of what lies "
                     "above in z; let gravity point along -z or switch model.sediment off");
  }
  SedimentScene out{make_material<float>(s, {from.model.yield, from.model.yield_fit, from.model.rheology})};
  out.effective_pressure = from.model.effective_pressure;
  const double gravity = -from.domain.gravity.z();
  out.submerged_weight = static_cast<float>(submerged_weight(s.bed_density(), s.pore_density, gravity));
  out.pore_stiffness = static_cast<float>(tait_stiffness(s.pore_density, sound_speed));
  const double submerged_density = s.bed_density() - s.pore_density;
  out.laplace_tolerance = static_cast<float>(1e-4 * submerged_density * sound_speed * sound_speed / 100);
  return out;
}

template <int Dim>
ErosionScene<Dim> make_erosion(const Case& from) {
  const SedimentParameters& s = from.sediment();
  const double g = from.domain.gravity.norm();
  const double rho = from.water.density;
  const double viscosity = from.water.viscosity;
  ErosionScene<Dim> out;
  const double d_star = dimensionless_diameter(s.grain_diameter, s.grain_density, rho, g, viscosity);
  out.bed_shear = from.model.bed_shear;
  out.as_printed = from.model.implementation == Implementation::paper;
  // Sums over a lattice with the top layer left out lie between the two (docs/theory.md).
  out.surface_fill = out.as_printed || from.numerics.smoothing_ratio > 1.55 ? 0.81F : 0.85F;
  out.fill_hysteresis = out.as_printed ? 0 : 0.07F;
  out.diameter = static_cast<float>(s.grain_diameter);
  out.roughness = static_cast<float>(s.roughness > 0 ? s.roughness : s.grain_diameter);
  out.grain_density = static_cast<float>(s.grain_density);
  out.grain_weight = static_cast<float>(grain_weight_stress(s.grain_density, rho, g, s.grain_diameter));
  out.gravity = static_cast<float>(g);
  for (int k = 0; k < Dim; ++k) out.down[k] = static_cast<float>(from.domain.gravity[axis<Dim>(k)] / g);
  out.critical_shields = static_cast<float>(s.critical_shields);
  out.lift_ratio = static_cast<float>(s.lift_ratio);
  out.dimensionless_diameter = static_cast<float>(d_star);
  out.settling_velocity = static_cast<float>(settling_velocity(d_star, s.grain_diameter, viscosity / rho));
  out.dilute = 0.312F;
  out.dense = 0.33F;
  out.return_stress = 0.8F;
  out.return_speed = static_cast<float>(0.01 * std::sqrt(g * s.grain_diameter));
  out.return_time = static_cast<float>(std::sqrt(s.grain_diameter / g));
  out.solids_share = out.as_printed ? 1 : static_cast<float>(1 - s.porosity);
  out.einstein_coefficient = out.as_printed ? 0.5F : 2.5F;
  return out;
}

/// Sediment is calm while its stress is below 98 % of the yield stress (m gdot/2 = 4), or it is sheared by less than 1
/// % in a second; it has to be slower than what moves it by 2 % of a spacing, for the time a grain needs to fall two
/// spacings.
RestCriteria make_rest(const Case& from) {
  const double g = from.domain.gravity.norm();
  const double dp = from.numerics.spacing;
  RestCriteria out;
  out.shear_rate = static_cast<float>(std::max(8 / from.sediment().regularisation, 0.01));
  out.wake_shear_rate = 1.5F * out.shear_rate;
  out.speed = static_cast<float>(0.01 * std::sqrt(g * dp));
  out.time = static_cast<float>(2 * std::sqrt(dp / g));
  return out;
}

SeepageScene make_seepage(const Case& from, double sound_speed) {
  const SedimentParameters& s = from.sediment();
  const double solids = 1 - s.porosity;
  const double g = -from.domain.gravity.z();
  SeepageScene out;
  out.mixture = from.model.seepage == SeepageModel::mixture;
  if (out.mixture) {
    out.solids_at_rest = static_cast<float>(solids);
    out.grain_diameter = static_cast<float>(s.grain_diameter);
    out.skeleton_stiffness =
        static_cast<float>(skeleton_stiffness(solids, s.grain_density, s.pore_density, sound_speed));
    // Both sets free of each other: c^2 (1 + phi rho_w/(n rho_grain)), the fastest wave (docs/theory.md).
    out.fast_wave = std::sqrt(1 + solids * s.pore_density / (s.porosity * s.grain_density));
  }
  out.pore_pressure = from.model.pore_pressure == PorePressureModel::diffusion;
  if (out.pore_pressure) {
    const double conductivity =
        hydraulic_conductivity(permeability(s.porosity, s.grain_diameter), from.water.density, from.water.viscosity, g);
    out.consolidation =
        static_cast<float>(consolidation_coefficient(conductivity, s.oedometer_modulus, from.water.density * g));
    out.pore_stiffness = static_cast<float>(s.bed_density() * sound_speed * sound_speed);
  }
  return out;
}

/// Whether walls move. Throws InputError where a moving wall's motion is not known.
bool has_moving_walls(const Case& from, const ParticleSet& particles) {
  if (count_by_type(particles)[static_cast<std::size_t>(ParticleType::moving_wall)] == 0) return false;
  const auto numbers = particles.scalars.find(motion_array);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles.type[i] != ParticleType::moving_wall) continue;
    const float number = numbers == particles.scalars.end() ? 0 : numbers->second[i];
    if (number >= 1 && number <= static_cast<float>(from.motions.size())) continue;
    throw InputError(
        fmt::format("{}: moving wall particle {} has the motion {:g} in the array Motion, and the case has "
                    "{}; fill the scene again with gencase",
                    from.file.string(), particles.id[i], number, from.motions.size()));
  }
  return true;
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

/// A node of the lattice the scene was filled on: a wall particle, which stays there, or else by gencase's convention
/// half a spacing inside the domain.
template <int Dim>
Vec<Dim, double> lattice_node(const Case& from, const ParticleSet& particles) {
  std::size_t wall = particles.size();
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const bool first = wall == particles.size() || particles.id[i] < particles.id[wall];
    if (particles.type[i] == ParticleType::wall && first) wall = i;
  }
  if (wall < particles.size()) return in_dimension<Dim>(particles.position[wall]);
  return in_dimension<Dim>(from.domain.from + Vec3::Constant(0.5 * from.numerics.spacing));
}

template <int Dim>
Scene<Dim> make(const Case& from, const ParticleSet& particles) {
  Scene<Dim> s;
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
  for (int k = 0; k < Dim; ++k) {
    const std::string name(1, "xyz"[axis<Dim>(k)]);
    const auto& wanted = from.domain.periodic;
    periodic[k] = std::find(wanted.begin(), wanted.end(), name) != wanted.end();
    if (!periodic[k]) continue;
    low[k] = s.domain_from[k];
    high[k] = s.domain_to[k];
    if (high[k] - low[k] < 2 * s.list_reach) {
      throw InputError(fmt::format(
          "{}: domain.periodic: the period along {} ({}) is shorter than twice the neighbour "
          "list's reach ({}); make the domain longer or the spacing smaller",
          from.file.string(), name, format_quantity(high[k] - low[k], "m"), format_quantity(2 * s.list_reach, "m")));
    }
  }
  s.lattice = Lattice<Dim>(low, high, periodic, s.list_reach);

  const double c = n.sound_speed_factor * n.maximum_speed;
  for (int k = 0; k < Dim; ++k) s.gravity[k] = static_cast<float>(from.domain.gravity[axis<Dim>(k)]);
  s.sound_speed = static_cast<float>(c);
  s.water_density = static_cast<float>(from.water.density);
  s.water_viscosity = static_cast<float>(from.water.viscosity);
  s.quarter_root_viscosity = static_cast<float>(std::pow(from.water.viscosity / from.water.density, 0.25));
  s.wall_friction = from.model.wall_friction == WallFriction::smooth;
  s.sediment_density = s.water_density;
  s.diffusion = static_cast<float>(2 * n.density_diffusion * h * c);
  s.artificial_viscosity = static_cast<float>(n.artificial_viscosity * c * h);
  s.cfl = n.cfl;
  s.two_pass = n.integrator == Integrator::two_pass;
  s.viscosity = n.viscosity;
  s.viscous_tolerance = n.viscous_tolerance;
  s.viscous_iterations = n.viscous_iterations;
  s.has_moving_walls = has_moving_walls(from, particles);
  s.has_sediment = count_by_type(particles)[static_cast<std::size_t>(ParticleType::sediment)] > 0;
  if (s.has_sediment) {
    s.no_slip = NoSlip<Dim>(h, s.spacing);
    s.sediment = make_sediment(from, c);
    s.seepage = make_seepage(from, c);
    // The particles of a mixture are the grains alone.
    s.sediment_density =
        static_cast<float>(s.seepage.mixture ? from.sediment().grain_density : from.sediment().bed_density());
    s.has_states = from.model.sediment == SedimentModel::three_state;
    if (s.has_states) s.erosion = make_erosion<Dim>(from);
    // What seeps or drains is never at rest.
    s.may_rest = from.model.rest && from.domain.gravity.norm() > 0 && !s.seepage.mixture && !s.seepage.pore_pressure;
    if (s.may_rest) s.rest = make_rest(from);
  }
  return s;
}

}  // namespace

AnyScene make_scene(const Case& from, const ParticleSet& particles) {
  if (!(from.numerics.maximum_speed > 0)) {
    throw InputError(from.file.string() +
                     ": numerics.maximum_speed is not resolved; fill the scene again with gencase");
  }
  if (from.info.dimension == 3) return make<3>(from, particles);
  return make<2>(from, particles);
}

}  // namespace thalweg
