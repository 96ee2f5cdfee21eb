#pragma once

#include "solver/backend/device.hpp"
#include "solver/models/bed_load/arrays.hpp"
#include "solver/models/openings/flow.hpp"
#include "solver/state/particles.hpp"
#include "solver/state/scene.hpp"

// Bed load that comes in through an inlet. It is a row of sediment particles below the inlet's lower edge, a spacing
// apart, in the place of the ground's highest row. All of it drifts with one speed; its skeleton stands still, as the bed's
// does (models/bed_load). Behind the plane a particle is bed load like the others.
namespace thalweg {

/// Particle pass: the row of each inlet.
template <int Dim>
struct PrescribeFeedPass {
  using reads = Reads<field::place, field::flow, field::matter, field::position, field::role>;
  using writes = Writes<field::flow, field::matter, field::role, field::drift>;

  Record* records;
  const Position* positions;
  Role* roles;
  Drift* drift;
  const Zone* zones;
  const double* levels;
  const BesideOpening* beside;
  const double* feeds;  // [m/s] of the rows
  Index count;          // of zones
  Scene<Dim> scene;

  HOST_DEVICE void operator()(Index i) const {
    if (roles[i] != Role::prescribed || !is_sediment(records[i])) return;
    for (Index n = 0; n < count; ++n) {
      const Zone& zone = zones[n];
      if (!zone.feeds || !is_in_feed(zone, in_opening(zone, positions[i].x))) continue;
      return prescribe(i, zone, pressure_in_zone(zone, levels[n], beside[n].pressure, positions[i].x, scene), feeds[n]);
    }
    roles[i] = Role::integrated;
  }

 private:
  /// of_water [Pa]: at the particle's middle, if water were in its place; half a spacing of the bed lies over it.
  HOST_DEVICE void prescribe(Index i, const Zone& zone, double of_water, double speed) const {
    Record& r = records[i];
    r.kind = kind::bed_load;
    for (int c = 0; c < 3; ++c) {
      r.velocity[c] = 0;
      drift[i].velocity[c] = static_cast<float>(speed * zone.flow[c]);
    }
    const double heavier = double(scene.sediment_density) - double(scene.water_density);
    const double pressure = of_water - heavier * double(scene.gravity[Dim - 1]) * 0.5 * zone.spacing;
    r.excess = static_cast<float>(tait_excess(pressure, double(scene.stiffness(kind::bed_load))));
  }
};

/// Particle pass: the skeleton of an inlet's row stands still, whatever the implicit solve has made of its velocity. Without
/// it the water dragged the row along, by 15 % of its speed.
struct HoldFeedPass {
  using reads = Reads<field::flow, field::matter, field::role>;
  using writes = Writes<field::flow>;

  Record* records;
  const Role* roles;

  HOST_DEVICE void operator()(Index i) const {
    if (roles[i] != Role::prescribed || !is_sediment(records[i])) return;
    for (float& u : records[i].velocity) u = 0;
  }
};

/// Particle pass: a particle's part of the bed load next to an inlet, whose sum is the volume of grains per time and width
/// [m^2/s]. It counts with a hat from 4 to 10 spacings behind the plane: before that the bed still takes up what the inlet
/// brings, and particles that pass one behind the other always count the same.
template <int Dim>
struct BedLoadBesidePass {
  using reads = Reads<field::place, field::flow, field::matter, field::position, field::role, field::drift>;
  using writes = Writes<>;

  const Record* records;
  const Position* positions;
  const Role* roles;
  const Drift* drift;
  const Zone* zone;
  double grains;  // share of the bed's volume [-]

  HOST_DEVICE double operator()(Index i) const {
    const Record& r = records[i];
    if (roles[i] != Role::integrated || r.volume == 0 || r.kind != kind::bed_load) return 0;
    const InOpening in = in_opening(*zone, positions[i].x);
    const double half = 3 * zone->spacing;
    const double weight = 1 - fabs(in.along - 7 * zone->spacing) / half;
    if (!(weight > 0) || fabs(in.across) > zone->half_across) return 0;
    double speed = 0;
    for (int c = 0; c < 3; ++c) speed += (double(r.velocity[c]) + double(drift[i].velocity[c])) * zone->flow[c];
    return grains * double(r.volume) * speed * weight / (half * 2 * zone->half_across);
  }
};

}  // namespace thalweg
