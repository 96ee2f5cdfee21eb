#pragma once

#include <cmath>

#include "physics/sediment/dilatancy.hpp"
#include "physics/seepage/consolidation.hpp"
#include "solver/models/bed/arrays.hpp"
#include "solver/models/pore_pressure/arrays.hpp"
#include "solver/models/pore_pressure/scene.hpp"
#include "solver/passes/sweep.hpp"
#include "solver/state/step_state.hpp"

// Excess pore pressure p_e on the sediment of a single-layer bed:
//   dp_e/dt = c_v lap p_e + M d(excess)/dt,   p_e = 0 on the bed's surface, no flow into walls,
// the second term the load that the bed's own compression puts on the water, M its stiffness rho_bed c^2. Diffusion by
// Runge-Kutta-Legendre stages, as many as the step needs: a coarse bed drains in less than a millisecond.
namespace thalweg {

namespace field {
/// The work quad of a stage: p_e before it [Pa].
inline constexpr Field stage_pressure{"StagePressure", quad_work};
}  // namespace field

/// Arrays of the diffusion, kept between steps.
template <class Device>
struct PoreDiffusion {
  template <class T>
  using Buffer = typename Device::template Buffer<T>;
  Buffer<float> loss;    // through the bed's surface, over p_e [1/m^2]
  Buffer<float> before;  // p_e of the stage before [Pa]
  int stages = 0;        // of the last step
};

/// Pair sweep: the loss of a particle to the drained surface above it. With p_e odd about the surface a pressure linear
/// in the depth x must not diffuse; what neighbours leave of 2 sum V_b F (p_a - p_b) is then 2 |sum V_b grad W| p_a/x.
template <int Dim>
struct DrainageSweep {
  using neighbours = Neighbours<field::place, field::matter>;
  using reads = Reads<field::matter>;
  using writes = Writes<>;
  static constexpr unsigned kernel = kernel_value | kernel_gradient;
  template <class L>
  struct Sum {
    L filled;
    Vec<Dim, L> gradient;
  };

  const Record* records;
  float* loss;
  Scene<Dim> scene;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT&, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    const L volume = lane_select(is_water(b), L(0.0F), b.volume);
    sum.filled += volume * g.W;
    const L weight = volume * g.F;
    for (int k = 0; k < Dim; ++k) sum.gradient[k] += weight * g.r[k];
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    loss[i] = 0;
    if (!is_sediment(records[i])) return;
    const auto h = static_cast<float>(scene.smoothing_length);
    const float share_above = 1 - sum.filled;
    float gradient2 = 0;
    for (int k = 0; k < Dim; ++k) gradient2 += sum.gradient[k] * sum.gradient[k];
    const float gradient = sqrtf(gradient2);
    if (share_above < least_share_above || h * gradient < least_surface_gradient) return;
    loss[i] = 2 * gradient / (h * depth_below_surface(share_above));
  }
};

/// Pair sweep: one stage, p_e in the work quad: p_new = mu p + nu p_before + tau [2 sum V_b F (p - p_b) - loss p].
template <int Dim>
struct DiffusionStage {
  using neighbours = Neighbours<field::place, field::matter, field::stage_pressure>;
  using reads = Reads<field::matter, field::stage_pressure>;
  using writes = Writes<field::pore_pressure>;
  static constexpr unsigned kernel = kernel_gradient;
  template <class L>
  struct Sum {
    L laplacian;
  };

  const Record* records;
  const float* loss;
  float* before;
  float* pressure;
  Scene<Dim> scene;
  float mu;
  float nu;
  float diffusivity;  // of the stage [m^2/s]
  const StepState* state;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    const L exchanged = L(2.0F) * b.volume * g.F * (a.work[0] - b.work[0]);
    sum.laplacian += lane_select(is_sediment(b), exchanged, L(0.0F));
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    const Record& r = records[i];
    const float p = r.work[0];
    const float of_before = before[i];
    before[i] = p;
    const auto tau = static_cast<float>(double(diffusivity) * state->step.dt);
    if (is_sediment(r)) pressure[i] = mu * p + nu * of_before + tau * (sum.laplacian - loss[i] * p);
  }
};

/// Largest dt of an explicit step: 2 over the largest eigenvalue, which is below twice the largest row sum. That is
/// 2 * 3.5 c_v/h^2 inside (-h^2 times the integral of F is 3.5), with up to 2 * 0.75/0.1 more at the surface.
template <int Dim>
double explicit_diffusion_step(const Scene<Dim>& scene) {
  constexpr double largest_row = 2 * 3.5 + 2 * 0.75 / 0.1;
  return scene.smoothing_length * scene.smoothing_length / (largest_row * double(scene.pores.consolidation));
}

/// Particle pass: the change of a packing that is sheared, and the water that it sucks in or presses out,
///   d phi/dt = -phi gdot tan psi,   dp_e/dt = -M gdot tan psi
/// M the modulus of the packing (dilatancy.hpp).
struct DilationPass {
  using reads = Reads<field::matter, field::sediment, field::solids, field::pore_pressure>;
  using writes = Writes<field::solids, field::pore_pressure>;

  const Record* records;
  const Sediment* sediment;
  float* solids;
  float* pressure;
  PoreScene law;
  const StepState* state;

  HOST_DEVICE void operator()(Index i) const {
    if (!is_sediment(records[i]) || is_resting(records[i])) return;
    const Sediment& s = sediment[i];
    const float steady = steady_solids(law.critical_solids, law.water_viscosity, s.strain_rate, s.effective_pressure);
    const float opens =
        static_cast<float>(state->step.dt) * s.strain_rate * dilatancy(law.dilatancy, solids[i], steady);
    pressure[i] -= law.modulus * opens;
    solids[i] -= solids[i] * opens;
  }
};

/// The whole step: source, then diffusion, in as many stages as a step of `longest` [s] would need.
/// excess_pore_pressure of particles other than sediment stays 0.
template <int Dim, class Device>
void advance_pore_pressure(Device& on, Particles<Device>& p, const Scene<Dim>& scene, PoreDiffusion<Device>& diffusion,
                           const StepState* state, double longest) {
  Record* records = p.record.data();
  const Rates* rates = p.rates.data();
  float* pressure = p.excess_pore_pressure.data();
  const auto stiffness = static_cast<double>(scene.pores.stiffness);
  on.for_each(p.fluid_count,
              declare<Reads<field::matter, field::rates, field::pore_pressure>, Writes<field::pore_pressure>>(
                  [=] HOST_DEVICE(Index i) {
                    const auto source = static_cast<float>(stiffness * state->step.dt);
                    if (is_sediment(records[i])) pressure[i] += source * rates[i].excess_rate;
                  }));
  if (scene.pores.critical_solids > 0) {
    on.for_each(p.fluid_count, DilationPass{records, p.sediment.data(), p.solids.data(), pressure, scene.pores, state});
  }
  diffusion.stages = 0;
  if (!(scene.pores.consolidation > 0)) return;
  diffusion.loss.resize(p.count);
  diffusion.before.resize(p.count);
  float* loss = diffusion.loss.data();
  float* before = diffusion.before.data();
  on.for_each(p.fluid_count, declare<Reads<>, Writes<>>([=] HOST_DEVICE(Index i) { before[i] = 0; }));
  sweep(on, p, scene, p.near_sediment(), DrainageSweep<Dim>{records, loss, scene});
  const int stages = legendre_stages(longest / explicit_diffusion_step(scene));
  const double share = 2.0 / (double(stages) * (stages + 1));
  for (int j = 1; j <= stages; ++j) {
    on.for_each(p.fluid_count, declare<Reads<field::pore_pressure>, Writes<field::stage_pressure>>(
                                   [=] HOST_DEVICE(Index i) { records[i].work[0] = pressure[i]; }));
    const double mu = j == 1 ? 1 : (2.0 * j - 1) / j;
    const double diffusivity = mu * share * double(scene.pores.consolidation);
    sweep(on, p, scene, p.near_sediment(),
          DiffusionStage<Dim>{records, loss, before, pressure, scene, static_cast<float>(mu),
                              static_cast<float>(j == 1 ? 0 : (1.0 - j) / j), static_cast<float>(diffusivity), state});
  }
  diffusion.stages = stages;
}

}  // namespace thalweg
