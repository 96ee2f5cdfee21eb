#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "solver/state/step_state.hpp"

// Reports of a step and of a simulation to the host: plain numbers, no particles.
namespace thalweg {

/// A position in double; the place in the record follows it.
struct Position {
  double x[3];  // [m]
};

/// A particle taken out of the run because it left the domain.
struct ExcludedParticle {
  std::int64_t id;
  std::uint8_t type;
  Position position;
  float velocity[3];  // [m/s]
  float mass;         // [kg]
};

/// Outcome of the viscous part of a step.
struct ViscousResult {
  int iterations = 0;
  double residual = 0;  // over the momentum one step of gravity gives [-]
  bool converged = true;
  int retries = 0;          // solves that had to be made again
  std::int64_t capped = 0;  // particles whose viscosity was cut
};

/// The report of one step to the run loop.
struct StepReport {
  double dt = 0;  // [s]
  Limiter limiter = Limiter::sound;
  double largest_speed = 0;  // [m/s] before the step
  std::int64_t fluid = 0;    // particles of the fluid
  ViscousResult viscous;
  int pressure_sweeps = 0;       // of the effective pressure from Laplace's equation
  bool pressure_settled = true;  // false: the most sweeps allowed were not enough
  bool diverged = false;
  std::vector<ExcludedParticle> excluded;
};

/// Mass that crossed the edge of the simulation since its start [kg]; per metre of width in 2-D.
struct MassLedger {
  double in = 0;    // of particles born
  double out = 0;   // of particles that died where they were meant to
  double lost = 0;  // of particles excluded: they left the domain where nothing was meant to
};

/// Mass that came in through an opening of the scene, less what went out [kg]; per metre of width in 2-D.
struct OpeningFlux {
  std::string name;
  double water = 0;        // that crossed its plane, without the grains that it carries
  double sediment = 0;     // parcels with the water in their pores
  double grains = 0;       // that water carries
  double level = 0;        // [m] z of the water's surface in the scene next to it; NaN where it does not stand upright
  bool overflows = false;  // the level stands above the opening
};

/// A bed that is a surface (model.sediment = "surface"); volumes in 2-D per metre of width.
struct BedReport {
  double time = 0;             // [s] that the bed's changes stand for
  double factor = 0;           // of that time over the water's, in the last window [-]
  double grains = 0;           // [m^3] volume of the bed's grains
  double fed = 0;              // [m^3] that came in at its ends
  double left = 0;             // [m^3] and that went out
  double lifted = 0;           // [m^3] and that the water took, less those that settled
  double lowest = 0;           // [m] level of its surface
  double highest = 0;          // [m]
  double scour = 0;            // [m] largest fall of a column since the start
  double scour_at[2] = {};     // [m] x and y of that column
  std::int64_t steps = 0;      // bed steps
  std::int64_t unsettled = 0;  // of these, under a stress that had not settled
};

/// Sums over the fluid; 2-D: per metre of width.
struct Totals {
  double kinetic_energy = 0;       // [J]
  double potential_energy = 0;     // [J] from z = 0, along gravity
  double internal_energy = 0;      // [J] of compression; not of sediment at rest, whose pressure does no work on it
  double water_mass = 0;           // [kg]
  double sediment_mass = 0;        // [kg]
  double grain_mass = 0;           // [kg] of all grains; 0 unless the water carries some (models/suspended_load)
  double suspended_mass = 0;       // [kg] of the grains that the water carries
  double bulk_velocity = 0;        // [m/s] of a driven current, mean over the water's mass (models/current)
  double drive = 0;                // [m/s^2] its acceleration
  double momentum[3] = {0, 0, 0};  // [kg m/s]
  // Sediment particles: all, at rest, and in the states they may have.
  std::int64_t sediment = 0;
  std::int64_t resting = 0;
  std::int64_t bed_load = 0;
  std::int64_t suspended = 0;

  HOST_DEVICE Totals& operator+=(const Totals& b) {
    kinetic_energy += b.kinetic_energy;
    potential_energy += b.potential_energy;
    internal_energy += b.internal_energy;
    water_mass += b.water_mass;
    sediment_mass += b.sediment_mass;
    grain_mass += b.grain_mass;
    suspended_mass += b.suspended_mass;
    for (int c = 0; c < 3; ++c) momentum[c] += b.momentum[c];
    sediment += b.sediment;
    resting += b.resting;
    bed_load += b.bed_load;
    suspended += b.suspended;
    return *this;
  }
};

}  // namespace thalweg
