#pragma once

#include "common/error.hpp"
#include "common/particles.hpp"
#include "physics/water/guide_zone.hpp"
#include "physics/water/log_profile.hpp"
#include "solver/backend/device.hpp"
#include "solver/models/current/scene.hpp"
#include "solver/models/mixing_length/arrays.hpp"
#include "solver/state/particles.hpp"
#include "solver/state/scene.hpp"

// The guide zone of a periodic flume (physics/water/guide_zone.hpp). The height over the ground is the mixing length's
// distance to the nearest wall or bed, so that the profile follows a bed that has moved.
namespace thalweg {

/// Sums over the zone's water, weighted with mass and ramp.
struct GuideSums {
  double mass = 0;      // [kg]
  double momentum = 0;  // along the flow [kg m/s]
  double of_law = 0;    // of the logarithmic profile [kg m/s]
  double height = 0;    // over the ground [kg m]

  HOST_DEVICE GuideSums& operator+=(const GuideSums& other) {
    mass += other.mass;
    momentum += other.momentum;
    of_law += other.of_law;
    height += other.height;
    return *this;
  }
};

/// The ramp at a particle's place [-]; 0 outside of the zone, and of what is no water over ground.
HOST_DEVICE inline double ramp_at(const GuideZone& zone, const Record& r, const Position& x, const Eddies& eddies) {
  if (!is_water(r) || r.volume == 0 || !(eddies.wall_distance > 0)) return 0;
  double along = x.x[zone.component] - zone.from;
  if (along < 0) along += zone.period;
  return guide_ramp(along, zone.length);
}

/// Particle pass: a particle's part of the sums.
struct GuideSumsPass {
  using reads = Reads<field::place, field::flow, field::matter, field::mass, field::position, field::eddies>;
  using writes = Writes<>;

  const Record* records;
  const Position* positions;
  const float* mass;
  const Eddies* eddies;
  const Guide* guide;
  GuideZone zone;

  HOST_DEVICE GuideSums operator()(Index i) const {
    const double ramp = ramp_at(zone, records[i], positions[i], eddies[i]);
    if (!(ramp > 0)) return {};
    const double m = ramp * double(mass[i]);
    const auto height = double(eddies[i].wall_distance);
    const double law = log_profile(guide->next, height, zone.viscosity, zone.roughness);
    return {m, m * double(records[i].velocity[zone.component]), m * law, m * height};
  }
};

/// The guide of a step. The profile's friction velocity is that of the step before, as its shape hardly depends on it.
HOST_DEVICE inline Guide guide_of(const Guide& before, const GuideSums& sums, const GuideZone& zone) {
  Guide now;
  now.friction = now.next = before.next;
  if (!(sums.mass > 0)) return now;
  const double velocity = sums.momentum / sums.mass;
  now.scale = sums.of_law > 0 ? sums.momentum / sums.of_law : 0;
  now.rate = sums.of_law > 0 ? guide_rate(velocity, zone.length) : 0;
  const double depth = 2 * sums.height / sums.mass;
  if (velocity > 0) now.next = friction_velocity_of_current(velocity, depth, zone.viscosity, zone.roughness);
  return now;
}

/// Particle pass: the acceleration towards the profile.
struct GuidePass {
  using reads = GuideSumsPass::reads::With<field::rates>;
  using writes = Writes<field::rates>;

  const Record* records;
  const Position* positions;
  const Eddies* eddies;
  Rates* rates;
  const Guide* guide;
  GuideZone zone;

  HOST_DEVICE void operator()(Index i) const {
    const double ramp = ramp_at(zone, records[i], positions[i], eddies[i]);
    if (!(ramp > 0)) return;
    const double law = log_profile(guide->friction, double(eddies[i].wall_distance), zone.viscosity, zone.roughness);
    for (int c = 0; c < 3; ++c) {
      const double wanted = c == zone.component ? guide->scale * law : 0;
      const double a = ramp * guide->rate * (wanted - double(records[i].velocity[c]));
      rates[i].acceleration[c] += static_cast<float>(a);
    }
  }
};

/// Adds to the accelerations what the zone does to the water.
template <int Dim, class Device>
void guide_current(Device& on, const Particles<Device>& p, Rates* rates, const Scene<Dim>& scene, Guide* guide) {
  const GuideZone zone = scene.current.guide;
  on.reduce_then(
      p.fluid(), GuideSums{},
      GuideSumsPass{p.record.data(), p.position.data(), p.mass.data(), p.eddies.data(), guide, zone},
      [] HOST_DEVICE(GuideSums a, const GuideSums& b) { return a += b; },
      [=] HOST_DEVICE(const GuideSums& sums) { *guide = guide_of(*guide, sums, zone); });
  on.for_each(p.fluid_count, GuidePass{p.record.data(), p.position.data(), p.eddies.data(), rates, guide, zone});
}

/// Name of the zone's numbers in a checkpoint (ParticleSet::facts).
inline constexpr const char* guide_fact = "GuideZone";

/// The guide of a checkpoint, or that of a run that begins. Throws InputError for a checkpoint that has another.
inline Guide guide_of_run(const ParticleSet& from, const CurrentDrive& drive) {
  const auto known = from.facts.find(guide_fact);
  if (known == from.facts.end()) return {0, 0, 0, drive.start_friction};
  const std::vector<double>& n = known->second;
  if (n.size() != 4) {
    throw InputError("the checkpoint's field data " + std::string(guide_fact) + " has " + std::to_string(n.size()) +
                     " numbers and needs 4; start from a whole checkpoint");
  }
  return {n[0], n[1], n[2], n[3]};
}

}  // namespace thalweg
