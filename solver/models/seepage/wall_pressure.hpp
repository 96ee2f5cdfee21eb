#pragma once

#include "solver/passes/sweep.hpp"

namespace thalweg {

/// Pair sweep over wall particles: pressure from the water in reach, compression of the packing from the grains in
/// reach (kept as the wall's excess), both balanced for gravity as in passes/pressure.hpp; neither below zero. A
/// packing at rest is compressed by g.r/c^2 as water is, by the choice of its stiffness.
template <int Dim>
struct MixtureWallSweep {
  using neighbours = Neighbours<field::place, field::flow, field::matter>;
  using reads = Reads<>;
  using writes = Writes<field::flow, field::matter>;
  static constexpr unsigned kernel = kernel_value;
  template <class L>
  struct Sum {
    L water;
    L pressure;
    L grains;
    L excess;
  };

  Record* records;
  Scene<Dim> scene;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT&, const LaneT& f, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    const L weight = f.volume * g.W;
    const L of_grain = lane_select(is_sediment(f), weight, L(0.0F));
    const L of_water = weight - of_grain;
    const L g_dot_r = gravity_dot(scene, g.r);
    sum.water += of_water;
    sum.pressure += of_water * (f.pressure + L(scene.water_density) * (L(1.0F) + f.excess) * g_dot_r);
    sum.grains += of_grain;
    sum.excess += of_grain * (f.excess + L(1 / (scene.sound_speed * scene.sound_speed)) * g_dot_r);
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    const float pressure = sum.water > 0 ? sum.pressure / sum.water : 0;
    const float excess = sum.grains > 0 ? sum.excess / sum.grains : 0;
    records[i].pressure = pressure > 0 ? pressure : 0;
    records[i].excess = excess > 0 ? excess : 0;
  }
};

template <int Dim, class Device>
void extrapolate_mixture_to_walls(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  sweep(on, p, scene, p.walls_near_fluid(), MixtureWallSweep<Dim>{p.record.data(), scene});
}

}  // namespace thalweg
