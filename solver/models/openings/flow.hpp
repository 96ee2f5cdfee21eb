#pragma once

#include "physics/water/equation_of_state.hpp"
#include "physics/water/long_wave.hpp"
#include "solver/backend/device.hpp"
#include "solver/models/openings/zone.hpp"
#include "solver/models/suspended_load/arrays.hpp"
#include "solver/state/particles.hpp"
#include "solver/state/scene.hpp"
#include "solver/state/step_state.hpp"

// Water that enters and leaves. An inlet's particles move in columns, each with its own speed. An outlet's go on along
// the flow with the speed with which they have crossed its plane; when the water before the plane becomes faster or slower
// as a whole, so do they, and slowly they take its mean speed: without the first, water that starts at rest would stand in
// the zone for ever and dam the outlet, without the second what is slower than others would. Both zones have the pressure
// under the level that is imposed, or that of the water next to them. The equations of motion do not hold in them
// (Role::prescribed).
namespace thalweg {

/// Pressure [Pa] at a place in a zone.
template <int Dim>
HOST_DEVICE inline double pressure_in_zone(const Zone& zone, double level, double at_centre, const double* x,
                                           const Scene<Dim>& scene) {
  double pressure = 0;
  if (zone.is_full) {
    pressure = at_centre;
    for (int k = 0; k < Dim; ++k) {
      const int c = axis<Dim>(k);
      pressure += double(scene.water_density) * double(scene.gravity[k]) * (x[c] - zone.at[c]);
    }
  } else {
    const double g = -double(scene.gravity[Dim - 1]);
    pressure = double(scene.water_density) * g * (level - x[2]);
  }
  return pressure > 0 ? pressure : 0;
}

/// Particle pass: who is prescribed, and how.
template <int Dim>
struct PrescribePass {
  using reads = Reads<field::place, field::flow, field::matter, field::position, field::role>;
  using writes = Writes<field::flow, field::matter, field::role>;

  Record* records;
  const Position* positions;
  Role* roles;
  const Zone* zones;
  const double* levels;
  const BesideOpening* beside;
  const float* speeds;
  Index count;  // of zones
  Scene<Dim> scene;

  HOST_DEVICE void operator()(Index i) const {
    Record& r = records[i];
    if (roles[i] == Role::dormant || r.volume == 0 || !is_water(r)) return;
    const bool was_prescribed = roles[i] == Role::prescribed;
    Role role = Role::integrated;
    for (Index n = 0; n < count; ++n) {
      const Zone& zone = zones[n];
      if (zone.falls || (zone.enters && !was_prescribed)) continue;
      const InOpening in = in_opening(zone, positions[i].x);
      if (!is_in_zone(zone, in)) continue;
      role = Role::prescribed;
      prescribe(r, zone, speed(r, zone, in, beside[n], was_prescribed),
                pressure_in_zone(zone, levels[n] + beside[n].swell, beside[n].pressure, positions[i].x, scene));
    }
    roles[i] = role;
  }

 private:
  /// Along the flow [m/s].
  [[nodiscard]] HOST_DEVICE double speed(const Record& r, const Zone& zone, const InOpening& in,
                                         const BesideOpening& water, bool was_prescribed) const {
    if (zone.enters) {
      const float given = speeds[column_in(zone, in)];
      return given > 0 ? double(given) : 0;
    }
    double along = 0;
    for (int c = 0; c < 3; ++c) along += double(r.velocity[c]) * zone.flow[c];
    if (!was_prescribed) return along + water.entry;
    return along + water.change + water.share * (water.speed - along);
  }

  HOST_DEVICE void prescribe(Record& r, const Zone& zone, double along, double pressure) const {
    for (int c = 0; c < 3; ++c) r.velocity[c] = static_cast<float>(along * zone.flow[c]);
    r.excess = static_cast<float>(tait_excess(pressure, double(scene.stiffness(r.kind))));
  }
};

/// Volume of the water next to an opening [m^Dim], and summed with it the pressure at the opening's centre and the speed
/// along the flow.
struct WaterBeside {
  double volume = 0;
  double pressure = 0;
  double speed = 0;

  HOST_DEVICE WaterBeside& operator+=(const WaterBeside& other) {
    volume += other.volume;
    pressure += other.pressure;
    speed += other.speed;
    return *this;
  }
};

/// Particle pass: a particle's part of it. It counts within a zone's length of the plane, on the side of the scene: in the
/// opening's section, or anywhere over its lower edge.
template <int Dim>
struct WaterBesidePass {
  using reads = Reads<field::place, field::flow, field::matter, field::position, field::mass, field::role>;
  using writes = Writes<>;

  const Record* records;
  const Position* positions;
  const float* mass;
  const Role* roles;
  const Zone* zone;
  bool in_section;
  Scene<Dim> scene;

  HOST_DEVICE WaterBeside operator()(Index i) const {
    const Record& r = records[i];
    if (roles[i] != Role::integrated || r.volume == 0 || !is_water(r)) return {};
    const double* x = positions[i].x;
    const InOpening in = in_opening(*zone, x);
    const double inward = zone->enters ? in.along : -in.along;
    const double weight = weight_at(inward);
    if (!(weight > 0)) return {};
    const bool over_edge = in.up >= -zone->half_up && in.across >= -zone->half_across && in.across <= zone->half_across;
    if (in_section ? !is_in_section(*zone, in, 0) : !over_edge) return {};
    const double volume = weight * double(mass[i]) / double(scene.water_density);
    double at_centre = r.pressure;
    for (int k = 0; k < Dim; ++k) {
      const int c = axis<Dim>(k);
      at_centre -= double(scene.water_density) * double(scene.gravity[k]) * (x[c] - zone->at[c]);
    }
    double speed = 0;
    for (int c = 0; c < 3; ++c) speed += double(r.velocity[c]) * zone->flow[c];
    return {volume, at_centre * volume, speed * volume};
  }

 private:
  /// A hat over a whole number of spacings, with a mean of 1 over the zone's length: particles that pass one behind the
  /// other a spacing apart always count the same. Without it the depth went up and down by 2 % as they passed.
  [[nodiscard]] HOST_DEVICE double weight_at(double inward) const {
    const double half = floor(0.5 * zone->length / zone->spacing) * zone->spacing;
    const double from_middle = fabs(inward - half) / half;
    return from_middle < 1 ? zone->length / half * (1 - from_middle) : 0;
  }
};

/// The water next to an opening after a step of dt [s]. The pressure of a full inlet follows within some passages of
/// sound, an outlet's particles lose their deviation in four passages of its zone. A wave that runs out through the
/// level of an outlet has the velocity u' and the height u' H/c, H being the depth [m]: by that much the level gives way, or
/// the wave would come back (physics/water/long_wave.hpp). depth: 0 where no level is imposed. `takes`: volume per time of
/// a pump [m^3/s] (2-D: [m^2/s]).
HOST_DEVICE inline BesideOpening after_step(const BesideOpening& before, const WaterBeside& sum, double dt,
                                            double sound_time, const Zone& zone, double takes, double depth,
                                            double gravity) {
  constexpr double passages_of_sound = 20;
  constexpr double passages_of_zone = 4;
  BesideOpening now;
  const double pressure = sum.volume > 0 ? sum.pressure / sum.volume : 0;
  const double follows = dt / (passages_of_sound * sound_time);
  now.pressure = before.pressure + (follows < 1 ? follows : 1) * (pressure - before.pressure);
  const double speed = sum.volume > 0 ? sum.speed / sum.volume : before.speed;
  now.speed = zone.pumps && sum.volume > 0 ? takes * zone.length / sum.volume : speed;
  now.change = now.speed - before.speed;
  now.swell = before.swell;
  if (depth > 0) {
    now.swell = swell_after(before.swell, now.change * depth / wave_speed(depth, gravity), dt, depth, gravity);
  }
  now.entry = zone.pumps ? now.speed - speed : 0;
  const double share = dt * (now.speed > 0 ? now.speed : 0) / (passages_of_zone * zone.length);
  now.share = share < 1 ? share : 1;
  return now;
}

/// Tells which particles of a phase leave through an opening: at an outlet, those behind its plane or its zone; at an
/// inlet, the columns that have fallen dry, and water that is pushed back into it.
struct LeavesThrough {
  using reads = Reads<field::place, field::matter, field::position, field::role>;

  const Record* records;
  const Position* positions;
  const Role* roles;
  const Zone* zone;
  const float* speeds;
  bool sediment;

  HOST_DEVICE bool operator()(Index i) const {
    if (is_sediment(records[i]) != sediment) return false;
    const InOpening in = in_opening(*zone, positions[i].x);
    if (zone->enters) {
      if (sediment || !is_in_zone(*zone, in)) return false;
      return roles[i] == Role::prescribed ? speeds[column_in(*zone, in)] < 0 : in.along < -0.5 * zone->spacing;
    }
    // Water that falls sinks out of the section before lists are made anew, and grains that slide on the floor stand half
    // in it. But a bed under a fall stays, and water under another outlet is the scene's.
    const bool slides = records[i].kind == kind::bed_load || records[i].kind == kind::suspended;
    const double beside = (sediment ? !zone->falls || slides : zone->falls) ? zone->spacing : 0.01 * zone->spacing;
    const double end = zone->falls ? 0 : zone->length - zone->spacing;
    return in.along > end && in.along < zone->length + 2 * zone->spacing && is_in_section(*zone, in, beside);
  }
};

/// Particle pass: grains of a particle that leaves [m^3].
struct GrainsLeaving {
  using reads = LeavesThrough::reads::With<field::grains>;
  using writes = Writes<>;

  const double* grains;
  LeavesThrough leaves;

  HOST_DEVICE double operator()(Index i) const {
    const bool here = leaves.roles[i] != Role::dormant && leaves.records[i].volume > 0 && leaves(i);
    return here ? grains[i] : 0;
  }
};

}  // namespace thalweg
