#pragma once

#include <cmath>

#include "physics/seepage/consolidation.hpp"
#include "solver/passes/time_step.hpp"

// Excess pore pressure p_e on the sediment of a single-layer bed:
//   dp_e/dt = c_v lap p_e + M d(excess)/dt,   p_e = 0 on the bed's surface, no flow into walls,
// the second term what the bed's own compression puts on the water, M its stiffness rho_bed c^2. Diffusion by
// Runge-Kutta-Legendre stages, as many as the step needs: a coarse bed drains in less than a millisecond.
namespace thalweg {

/// Arrays of the diffusion, kept between steps.
template <class Device>
struct PoreDiffusion {
  template <class T>
  using Buffer = typename Device::template Buffer<T>;
  Buffer<float> loss;    // through the bed's surface, over p_e [1/m^2]
  Buffer<float> before;  // p_e of the stage before [Pa]
  int stages = 0;        // of the last step
};

/// Pair sweep: what a particle loses to the drained surface above it. With p_e odd about the surface a pressure linear
/// in the depth x must not diffuse; what neighbours leave of 2 sum V_b F (p_a - p_b) is then 2 |sum V_b grad W| p_a/x.
template <int Dim>
struct DrainageSweep {
  static constexpr unsigned quads = quad_place | quad_matter;
  template <class L>
  struct Sum {
    L filled;
    Vec<Dim, L> gradient;
  };

  const Record* records;
  float* loss;
  Scene<Dim> scene;

  template <class LaneT, class Sep, class L>
  HOST_DEVICE void pair(const LaneT&, const LaneT& b, const Sep& s, std::size_t, Sum<L>& sum) const {
    const L closeness = scene.kernel.closeness(lane_sqrt(s.r2));
    const L volume = lane_select(b.phase == L(phase_water), L(0.0F), b.volume);
    sum.filled += volume * scene.kernel.value(closeness);
    const L weight = volume * scene.kernel.gradient(closeness);
    for (int k = 0; k < Dim; ++k) sum.gradient[k] += weight * s.r[k];
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    loss[i] = 0;
    if (records[i].phase != phase_sediment) return;
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
  static constexpr unsigned quads = quad_place | quad_matter | quad_work;
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

  template <class LaneT, class Sep, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const Sep& s, std::size_t, Sum<L>& sum) const {
    const L F = scene.kernel.gradient(scene.kernel.closeness(lane_sqrt(s.r2)));
    const L exchanged = L(2.0F) * b.volume * F * (a.work[0] - b.work[0]);
    sum.laplacian += lane_select(b.phase > L(phase_water + 0.5F), exchanged, L(0.0F));
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    const Record& r = records[i];
    const float p = r.work[0];
    const float of_before = before[i];
    before[i] = p;
    const auto tau = static_cast<float>(double(diffusivity) * state->step.dt);
    if (r.phase == phase_sediment) pressure[i] = mu * p + nu * of_before + tau * (sum.laplacian - loss[i] * p);
  }
};

/// Largest dt of an explicit step: 2 over the largest eigenvalue, which is below twice the largest row sum. That is
/// 2 * 3.5 c_v/h^2 inside (-h^2 times the integral of F is 3.5), with up to 2 * 0.75/0.1 more at the surface.
template <int Dim>
double explicit_diffusion_step(const Scene<Dim>& scene) {
  constexpr double largest_row = 2 * 3.5 + 2 * 0.75 / 0.1;
  return scene.smoothing_length * scene.smoothing_length / (largest_row * double(scene.seepage.consolidation));
}

/// The whole step: source, then diffusion, in as many stages as a step of `longest` [s] would need.
/// excess_pore_pressure of particles other than sediment stays 0.
template <int Dim, class Device>
void advance_pore_pressure(Device& on, Particles<Device>& p, const Scene<Dim>& scene, PoreDiffusion<Device>& diffusion,
                           const StepState* state, double longest) {
  Record* records = p.record.data();
  const Rates* rates = p.rates.data();
  float* pressure = p.excess_pore_pressure.data();
  const auto stiffness = static_cast<double>(scene.seepage.pore_stiffness);
  on.for_each(p.fluid_count, [=] HOST_DEVICE(Index i) {
    const auto source = static_cast<float>(stiffness * state->step.dt);
    if (records[i].phase == phase_sediment) pressure[i] += source * rates[i].excess_rate;
  });
  diffusion.stages = 0;
  if (!(scene.seepage.consolidation > 0)) return;
  diffusion.loss.resize(p.count);
  diffusion.before.resize(p.count);
  float* loss = diffusion.loss.data();
  float* before = diffusion.before.data();
  on.for_each(p.fluid_count, [=] HOST_DEVICE(Index i) { before[i] = 0; });
  const auto sweep = [&](const auto& body) {
    on.template sweep<Dim>(p.list(), p.near_sediment(), records, scene.lattice.quantum, body);
  };
  sweep(DrainageSweep<Dim>{records, loss, scene});
  const int stages = legendre_stages(longest / explicit_diffusion_step(scene));
  const double share = 2.0 / (double(stages) * (stages + 1));
  for (int j = 1; j <= stages; ++j) {
    on.for_each(p.fluid_count, [=] HOST_DEVICE(Index i) { records[i].work[0] = pressure[i]; });
    const double mu = j == 1 ? 1 : (2.0 * j - 1) / j;
    const double diffusivity = mu * share * double(scene.seepage.consolidation);
    sweep(DiffusionStage<Dim>{records, loss, before, pressure, scene, static_cast<float>(mu),
                              static_cast<float>(j == 1 ? 0 : (1.0 - j) / j), static_cast<float>(diffusivity), state});
  }
  diffusion.stages = stages;
}

}  // namespace thalweg
