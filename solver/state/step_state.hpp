#pragma once

#include <cmath>
#include <cstdint>

#include "physics/host_device.hpp"
#include "solver/state/record.hpp"

namespace thalweg {

/// The bound that decides a time step.
enum class Limiter { sound, force, viscosity, output };
inline constexpr const char* limiter_name(Limiter l) {
  switch (l) {
    case Limiter::sound:
      return "sound";
    case Limiter::force:
      return "force";
    case Limiter::viscosity:
      return "viscosity";
    case Limiter::output:
      return "output";
  }
  return "";
}

/// Largest values in the scene; not finite or out of bounds when a run has diverged.
struct Extremes {
  float speed2 = 0;         // [m^2/s^2]
  float acceleration2 = 0;  // [m^2/s^4]
  float excess = 0;         // |rho/rho0 - 1| [-]
  bool finite = true;
};

struct TimeStep {
  double dt = 0;  // [s]
  Limiter limiter = Limiter::sound;
  Extremes extremes;
};

/// Progress of the implicit viscous solve of a step (models/implicit/conjugate_gradients.hpp).
struct ViscousState {
  // Sums over the particles near sediment of the residual r and the preconditioned one u = r/diagonal.
  double preconditioned = 0;  // r . u
  double before = 0;          // the same before the last iteration
  double alpha = 0;
  double beta = 0;
  double scale = 0;     // [kg m/s] residuals are compared with it
  double residual = 0;  // over the scale [-]
  int iterations = 0;
  int running = 0;    // 1: more iterations are needed
  int converged = 1;  // 1 also where nothing is to be solved
};

/// The step under way. It lives where the passes read it, on the device, so that the host need not wait between them.
/// The host writes a fresh one before every step and reads it after.
struct StepState {
  double longest = INFINITY;  // [s] the step may be
  std::int64_t number = 0;    // of the step, from the start of the run on
  TimeStep step;
  Extremes walls;                 // of moving walls; squares of speed and acceleration
  float sediment_viscosity = 0;   // [m^2/s] largest, where it is treated explicitly
  float eddy_viscosity = 0;       // [m^2/s] largest, of the water (models/sub_particle, models/mixing_length)
  int finds_eddies = 0;           // 1: the eddy viscosity is found anew in this step (models/mixing_length)
  int go = 1;                     // 0: the run has diverged
  int moves = 1;                  // 0: the run has diverged or the viscous solve is not finished; no particle moves
  double shift_velocity[3] = {};  // mean change of velocity by a shift [m/s]
  int shifts = 0;                 // 1: particles are shifted at the end of the step (models/shifting)
  ViscousState viscous;
  std::int64_t capped = 0;  // particles whose viscosity was cut
  Index woken = 0;          // particles of the bed, beside walls that move
  Index waiting = 0;        // particles of the bed that are due to stop or to wake (models/rest)
  float squared_drift = 0;  // [m^2] since the lists were made (lists/drift.hpp); infinite if a particle left the domain
};

/// Limit of the density excess: beyond it a run has diverged. Water does not compress by a third, and the equation of
/// state is used within a few percent.
inline constexpr float most_excess = 0.33F;

/// True if the numbers say that the run has diverged. The step stops there; no particle has moved by then.
HOST_DEVICE inline bool has_diverged(const Extremes& extremes) {
  return !extremes.finite || extremes.excess > most_excess;
}

}  // namespace thalweg
