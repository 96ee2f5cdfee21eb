#pragma once

#include <cmath>

#include "physics/sediment/surface_fill.hpp"
#include "solver/models/bed/arrays.hpp"
#include "solver/models/bed/scene.hpp"
#include "solver/models/implicit/viscous_system.hpp"
#include "solver/passes/sweep.hpp"

// Effective pressure from Laplace's equation in the bed (the theory of GPUSPH):
//   lap p_eff = 0 in the bed,   p_eff = w dp in its top layer,
//   p_w = sum_s [p_s + w g^ . (x_w - x_s)] V_s W / sum_s V_s W   at walls,
// w = (rho_bed - rho_pore) g and g^ the direction of gravity, so that a bed on a wall carries its weight.
// With the kernel's Laplacian the first is p_a = sum_b V_b F p_b/sum_b V_b F over sediment and walls, iterated (Jacobi)
// from the pressures of the last step; from the columns' weight where there are none. Every sweep reads the last one's
// pressures from the records' work quad and writes beside the records, so that the order of particles does not matter.
namespace thalweg {

namespace field {
/// The work quad during the iteration: pressure [Pa], and 1 in the bed's top layer.
inline constexpr Field laplace_pressure{"LaplacePressure", quad_work};
}  // namespace field

namespace laplace {

inline constexpr int most_sweeps = 1000;

/// Entries of field::laplace_pressure.
inline constexpr int pressure = 0;  // [Pa]
inline constexpr int in_top_layer = 1;

/// Pair sweep: marks the sediment of the top layer.
template <int Dim>
struct TopLayerSweep {
  using neighbours = Neighbours<field::place, field::matter>;
  using reads = Reads<>;
  using writes = Writes<field::laplace_pressure>;
  static constexpr unsigned kernel = kernel_value;
  template <class L>
  struct Sum {
    L share;
  };

  Record* records;
  Scene<Dim> scene;
  float full;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT&, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    sum.share += lane_select(is_water(b), L(0.0F), b.volume * g.W);
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    records[i].work[in_top_layer] = sum.share < full ? 1.0F : 0.0F;
  }
};

/// Pair sweep: one Jacobi iteration in the bed. A particle's own pressure does not enter, which is fastest.
template <int Dim>
struct JacobiSweep {
  using neighbours = Neighbours<field::place, field::matter, field::laplace_pressure>;
  using reads = Reads<>;
  using writes = Writes<field::sediment>;
  static constexpr unsigned kernel = kernel_gradient;
  template <class L>
  struct Sum {
    L weight;
    L pressure;
  };

  const Record* records;
  Sediment* sediment;
  Scene<Dim> scene;
  float top_pressure;  // [Pa]

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT&, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    const L bed = lane_select(is_water(b), L(0.0F), -b.volume * g.F);
    const L weight = lane_select(g.r2 > L(0.0F), bed, L(0.0F));
    sum.weight += weight;
    sum.pressure += weight * b.work[pressure];
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    if (!is_sediment(records[i])) return;
    const bool known = records[i].work[in_top_layer] != 0 || !(sum.weight > 0);
    sediment[i].effective_pressure = known ? top_pressure : sum.pressure / sum.weight;
  }
};

/// Pair sweep over wall particles: pressure of the sediment in reach with the weight between, not below zero.
template <int Dim>
struct WallSweep {
  using neighbours = Neighbours<field::place, field::matter, field::laplace_pressure>;
  using reads = Reads<>;
  using writes = Writes<field::sediment>;
  static constexpr unsigned kernel = kernel_value;
  template <class L>
  struct Sum {
    L weight;
    L pressure;
  };

  Sediment* sediment;
  Scene<Dim> scene;
  Vec<Dim, float> submerged_weight;  // (rho_bed - rho_pore) g as a vector [N/m^3]

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT&, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    const L weight = lane_select(is_sediment(b), b.volume * g.W, L(0.0F));
    L between = g.r[0] * L(submerged_weight[0]);
    for (int k = 1; k < Dim; ++k) between = between + g.r[k] * L(submerged_weight[k]);
    sum.weight += weight;
    sum.pressure += weight * (b.work[pressure] + between);
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    const float p = sum.weight > 0 ? sum.pressure / sum.weight : 0;
    sediment[i].effective_pressure = p > 0 ? p : 0;
  }
};

/// Takes over what a sweep found; returns the largest change [Pa].
template <class Device, class Wanted>
float take_over(Device& on, Record* records, const Sediment* sediment, Index count, const Wanted& wanted) {
  return on.reduce(
      count, 0.0F,
      declare<Reads<field::matter, field::sediment, field::laplace_pressure>, Writes<field::laplace_pressure>>(
          [=] HOST_DEVICE(Index i) {
            if (!wanted(records[i])) return 0.0F;
            const float change = fabsf(sediment[i].effective_pressure - records[i].work[pressure]);
            records[i].work[pressure] = sediment[i].effective_pressure;
            return change;
          }),
      [] HOST_DEVICE(float a, float b) { return a > b ? a : b; });
}

}  // namespace laplace

/// Largest effective pressure of the sediment [Pa]; 0 before the first solve.
template <class Device>
float largest_effective_pressure(Device& on, const Particles<Device>& p) {
  const Record* records = p.record.data();
  const Sediment* sediment = p.sediment.data();
  return on.reduce(p.fluid_count, 0.0F,
                   declare<Reads<field::matter, field::sediment>, Writes<>>([=] HOST_DEVICE(Index i) {
                     return is_sediment(records[i]) ? sediment[i].effective_pressure : 0.0F;
                   }),
                   [] HOST_DEVICE(float a, float b) { return a > b ? a : b; });
}

/// Solves for the effective pressure of all sediment, starting from the one it has. Stops when no pressure changes by
/// more than scene.sediment.laplace_tolerance in a sweep, or after laplace::most_sweeps. Returns the sweeps made.
template <int Dim, class Device>
int solve_laplace_pressure(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  using namespace laplace;
  Record* records = p.record.data();
  Sediment* sediment = p.sediment.data();
  const auto of_sediment = [] HOST_DEVICE(const Record& r) { return is_sediment(r); };
  const auto of_walls = [] HOST_DEVICE(const Record& r) { return is_wall(r); };
  const SedimentScene& law = scene.sediment;
  Vec<Dim, float> submerged_weight{};
  submerged_weight.vertical() = -law.submerged_weight;
  const float top_fill = surface_fill(scene.smoothing_length, scene.spacing, widest_narrow_kernel_of_laplace);
  const auto top_pressure = law.submerged_weight * static_cast<float>(scene.spacing);
  const WallSweep<Dim> at_walls{sediment, scene, submerged_weight};
  const JacobiSweep<Dim> in_the_bed{records, sediment, scene, top_pressure};

  on.for_each(p.count, declare<Reads<field::sediment>, Writes<field::laplace_pressure>>([=] HOST_DEVICE(Index i) {
                for (float& w : records[i].work) w = 0;
                records[i].work[pressure] = sediment[i].effective_pressure;
              }));
  sweep(on, p, scene, p.near_sediment(), TopLayerSweep<Dim>{records, scene, top_fill});
  int sweeps = 0;
  float change = INFINITY;
  while (change > law.laplace_tolerance && sweeps < most_sweeps) {
    sweep(on, p, scene, p.walls_near_fluid(), at_walls);
    take_over(on, records, sediment, p.count, of_walls);
    sweep(on, p, scene, p.near_sediment(), in_the_bed);
    change = take_over(on, records, sediment, p.fluid_count, of_sediment);
    ++sweeps;
  }
  // The viscous solve needs the quad next, and walls standing still in it.
  on.for_each(p.count, declare<Reads<>, Writes<field::viscous_vector>>([=] HOST_DEVICE(Index i) {
                for (float& w : records[i].work) w = 0;
              }));
  return sweeps;
}

}  // namespace thalweg
