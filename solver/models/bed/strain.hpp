#pragma once

#include <cmath>
#include <type_traits>

#include "physics/no_slip.hpp"
#include "physics/sediment/compression_under_water.hpp"
#include "solver/models/bed/arrays.hpp"
#include "solver/passes/continuity.hpp"
#include "solver/passes/integrate.hpp"
#include "solver/passes/velocity_gradient.hpp"

namespace thalweg {

/// Pair sweep over clusters with sediment in reach: density rate and rate of strain. The rate of strain of sediment is that
/// of sediment and walls: water slides over a bed. Where bed load drifts over its skeleton, densities change with
/// velocity plus drift, and the strain is the skeleton's. Walls count in the strain as if the
/// velocity went on through their surface (physics/no_slip.hpp), in the density rate with the velocity that they have.
/// Sediment with water in reach has its density by physics/sediment/compression_under_water.hpp, all else by the plain
/// sum.
template <int Dim, bool drifts>
struct ContinuityAndStrainSweep {
  using Read = Fields<field::place, field::flow, field::matter>;
  using neighbours = std::conditional_t<drifts, Read::With<field::drift_velocity>, Read>;
  using reads = neighbours;
  using writes = Writes<field::rates, field::sediment, field::dissipation>;
  static constexpr unsigned kernel = kernel_value | kernel_gradient;
  template <class L>
  struct Sum {
    L diffusion;
    L own;             // compression by sediment and walls [1/s]
    L by_water;        // by water [1/s]
    L bed_share;       // sum over sediment and walls of V W [-]
    L water_share;     // sum over water of V W [-]
    L water_pressure;  // of V W times its pressure at the place of a [Pa]
    GradientSum<Dim, L> velocity;
    WallDrag<Dim, L> walls;
  };

  ContinuitySweep<Dim> continuity;
  Sediment* sediment;
  float* dissipation;  // nullptr without the switch of the artificial viscosity

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    const L weight = b.volume * g.F;
    // The pressure of sediment at rest follows its neighbours', as a wall's does: in a current density does not diffuse
    // towards it, or the layer that slides over it would lose its pressure.
    const float to_resting = continuity.scene.bed_load.holds_surface ? 0.0F : 1.0F;
    const L diffusing = lane_select(is_resting(b), L(to_resting) * weight, weight);
    sum.diffusion += pair_diffusion(a, b, g, diffusing, same_phase(a, b), continuity.scene);
    const Vec<Dim, L> u = b.velocity - a.velocity;
    const auto b_water = is_water(b);
    // In the water's gradient, which only the switch of the artificial viscosity reads, water counts.
    const L of_water_too = lane_select(is_sediment(a), L(0.0F), weight);
    add_velocity(b, u, g, lane_select(b_water, of_water_too, weight), sum);
    L compression = dot(u, g.r);
    if constexpr (drifts) {
      for (int k = 0; k < Dim; ++k) compression += (b.work[k] - a.work[k]) * g.r[k];
    }
    compression = -weight * compression;
    const Scene<Dim>& scene = continuity.scene;
    const L g_dot_r = gravity_dot(scene, g.r);
    const L value = b.volume * g.W;
    const L share = lane_select(b_water, value, L(0.0F));
    sum.bed_share += value - share;
    const L of_water = lane_select(b_water, compression, L(0.0F));
    sum.own += compression - of_water;
    sum.by_water += of_water;
    sum.water_share += share;
    sum.water_pressure += share * (b.pressure + L(0.5F * (scene.water_density + scene.sediment_density)) * g_dot_r);
  }

  /// u = u_b - u_a, weight = V_b F.
  template <class LaneT, class L>
  HOST_DEVICE void add_velocity(const LaneT& b, const Vec<Dim, L>& u, const PairGeometry<Dim, L>& g, const L& weight,
                                Sum<L>& sum) const {
    sum.velocity.add(u, g, weight);
    sum.walls.add(lane_select(is_wall(b), -weight, L(0.0F)), g, u);
  }

  HOST_DEVICE void end(Index i, Sum<float> sum) const {
    float compression = sum.own + sum.by_water;
    const Record& r = continuity.records[i];
    const Scene<Dim>& scene = continuity.scene;
    float held = 0;
    const bool under_water = is_sediment(r) && sum.water_share > 0;
    if (under_water) {
      held = held_share(sum.bed_share - r.volume * scene.kernel.value(1.0F));
      const float apart = held * share_out_of_balance(pressure_difference(r, sum), pressure_band());
      compression = sum.own + apart * compression_by_water(sum.own, sum.by_water) + (1 - apart) * sum.by_water;
    }
    continuity.end(i, compression, sum.diffusion);
    if (under_water && !is_resting(r)) continuity.rates[i].excess_rate += held * exchange(r, sum);
    if (dissipation != nullptr) dissipation[i] = acting_share<Dim>(sum.velocity.gradient, continuity.scene);
    add_behind_walls(sum);
    float gradient[Dim][Dim];
    corrected_gradient(sum.velocity, gradient);
    const StrainRate strain = strain_rate<Dim>(gradient);
    sediment[i].strain_rate = strain.magnitude;
    sediment[i].lode_sine = strain.lode_sine;
  }

  /// The pressure of the water over a particle less its own [Pa].
  HOST_DEVICE static float pressure_difference(const Record& r, const Sum<float>& sum) {
    return sum.water_pressure / sum.water_share - r.pressure;
  }

  /// The pressure that a spacing more or less of either makes [Pa].
  [[nodiscard]] HOST_DEVICE float pressure_band() const {
    const Scene<Dim>& scene = continuity.scene;
    float g2 = 0;
    for (int k = 0; k < Dim; ++k) g2 += scene.gravity[k] * scene.gravity[k];
    return fabsf(scene.sediment_density - scene.water_density) * sqrtf(g2) * static_cast<float>(scene.spacing);
  }

  /// The rate at which sediment takes over the water's pressure [1/s].
  HOST_DEVICE float exchange(const Record& r, const Sum<float>& sum) const {
    const Scene<Dim>& scene = continuity.scene;
    const float impedance = scene.sediment_density * scene.sound_speed * static_cast<float>(scene.smoothing_length);
    return exchange_rate(pressure_difference(r, sum), pressure_band(), sum.water_share, impedance);
  }

  /// The wall's part of the gradient counts f' times: (f' - 1) U (x) sum k r, U the mean velocity of a less its walls'.
  HOST_DEVICE void add_behind_walls(Sum<float>& sum) const {
    const WallDrag<Dim, float>& walls = sum.walls;
    if (!(walls.coefficients > 0)) return;
    const float more = continuity.scene.no_slip.excess_of_strain(walls) / walls.coefficients;
    for (int i = 0; i < Dim; ++i) {
      for (int j = 0; j < Dim; ++j) sum.velocity.gradient[i][j] -= more * walls.exchange[i] * walls.lever[j];
    }
  }
};

/// Density rates of all fluid. Pure water takes the light sweep; clusters with sediment in reach take the one with the
/// velocity gradient, and so does the resting sediment that moving neighbours may wake.
template <int Dim, class Device>
void compute_density_rates(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  compute_water_density_rates(on, p, scene);
  if (!scene.has_sediment) return;
  const ContinuitySweep<Dim> water{p.record.data(), p.rates.data(), scene};
  const auto near_sediment = [&](const auto& with_strain) {
    sweep(on, p, scene, p.near_sediment(), with_strain);
    if (p.any_resting) sweep(on, p, scene, p.rest_front(), with_strain);
  };
  if (scene.has_drift) {
    near_sediment(ContinuityAndStrainSweep<Dim, true>{water, p.sediment.data(), p.dissipations()});
  } else {
    near_sediment(ContinuityAndStrainSweep<Dim, false>{water, p.sediment.data(), p.dissipations()});
  }
}

}  // namespace thalweg
