#include "solver/program/diagnosis.hpp"

#include <fmt/format.h>

#include <cmath>

#include "case/models/surface_bed.hpp"
#include "common/units.hpp"

namespace thalweg {
namespace {

const char* type_name(ParticleType type) {
  switch (type) {
    case ParticleType::wall:
      return "wall";
    case ParticleType::moving_wall:
      return "moving wall";
    case ParticleType::water:
      return "water";
    case ParticleType::sediment:
      break;
  }
  return "sediment";
}

bool is_fluid(ParticleType type) { return type == ParticleType::water || type == ParticleType::sediment; }

/// The fluid particle that is worst off: the first whose numbers are not finite, else the one farthest from its density
/// at rest.
std::size_t worst_particle(const ParticleSet& p, const Case& of, double sediment_density) {
  const bool sediment_is_wall = models::SurfaceBedOfCase::is_on(of);
  std::size_t worst = 0;
  double farthest = -1;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!is_fluid(p.type[i]) || (sediment_is_wall && p.type[i] == ParticleType::sediment)) continue;
    const double rho0 = p.type[i] == ParticleType::water ? of.water.density : sediment_density;
    const double excess = std::abs(double(p.density[i]) / rho0 - 1);
    if (!std::isfinite(excess) || !p.velocity[i].allFinite()) return i;
    if (excess > farthest) farthest = excess, worst = i;
  }
  return worst;
}

std::string cure(const Case& of, double largest_speed) {
  const Numerics& n = of.numerics;
  const double usual = Numerics{}.cfl;
  if (n.cfl > usual) return fmt::format("numerics.cfl is {:g}; set it to {:g}", n.cfl, usual);
  if (largest_speed > 2 * n.maximum_speed) {
    return fmt::format(
        "the flow reached {:.3g} m/s and the sound speed is meant for {:.3g} m/s; raise numerics.maximum_speed",
        largest_speed, n.maximum_speed);
  }
  return fmt::format(
      "lower numerics.cfl (now {:g}), raise numerics.maximum_speed (now {:.3g} m/s), or look for particles "
      "that start inside one another",
      n.cfl, n.maximum_speed);
}

}  // namespace

std::string diagnose(const StepReport& report, const ParticleSet& particles, const Case& of, const RunClock& clock) {
  const std::string when = fmt::format("run failed at t = {:.6g} s, step {}: ", clock.time, clock.step);
  if (!report.viscous.converged) {
    return when + fmt::format(
                      "the implicit viscosity did not converge, not even with the step halved to {:.2g} s (residual "
                      "{:.2g} after {} iterations in all, {:.2g} wanted); lower the sediment's consistency or "
                      "regularisation, or raise numerics.viscous_iterations or numerics.viscous_tolerance",
                      report.dt, report.viscous.residual, report.viscous.iterations, of.numerics.viscous_tolerance);
  }
  const double sediment_density = of.has_sediment() ? of.sediment().bed_density() : of.water.density;
  const std::size_t i = worst_particle(particles, of, sediment_density);
  const double rho0 = particles.type[i] == ParticleType::water ? of.water.density : sediment_density;
  const double excess = double(particles.density[i]) / rho0 - 1;
  std::string what = std::isfinite(excess) ? fmt::format("its density is {:+.0f} % off rest", 100 * excess)
                                           : std::string("its density is not a number");
  if (!particles.velocity[i].allFinite())
    what = "its velocity is not a number";
  else if (std::isfinite(excess) && std::abs(excess) < most_excess)
    what = "its acceleration is not a number";
  return when + fmt::format("particle {} ({}) at x = {:.4g} m, y = {:.4g} m, z = {:.4g} m has diverged, {}; {}",
                            particles.id[i], type_name(particles.type[i]), particles.position[i].x(),
                            particles.position[i].y(), particles.position[i].z(), what, cure(of, report.largest_speed));
}

}  // namespace thalweg
