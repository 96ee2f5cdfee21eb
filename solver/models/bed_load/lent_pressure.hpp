#pragma once

#include "physics/sediment/compression_under_water.hpp"
#include "solver/models/bed_load/arrays.hpp"
#include "solver/passes/momentum.hpp"
#include "solver/passes/pressure.hpp"

namespace thalweg {

/// Pair sweep over the surface of the bed: the pressure that water and bed feel of each other, the water's own brought to
/// the place of the grain, not below zero,
///   P = max(0, sum_w V_w W [p_w + rho_w g.r]/sum_w V_w W)
/// With the grain's own pressure p the noise of the water's density, which slides past, would press against the grains
/// like friction: water over a bed that moves at 8 times its threshold lost 1.2 to 1.7 times the momentum that its shear
/// stress took. But P does work that no change of density pays: drops onto a bed gained 0.19 dp of energy. So grains
/// take P where they lie in a bed and the pressures are near each other, and p where they fly (held_share()) or in an
/// impact (share_of_lent()). Grains at rest have the water's pressure already; but under a layer that moves their pressure
/// holds its weight, with which the water in reach would push the layer and itself apart. So in a current they take P, too.
template <int Dim>
struct LentPressureSweep : ExtrapolatedPressureSweep<Dim> {
  using Base = ExtrapolatedPressureSweep<Dim>;
  using reads = Reads<field::place, field::matter, field::flow>;
  using writes = Writes<field::lent_pressure>;
  template <class L>
  struct Sum {
    typename Base::template Sum<L> water;
    L bed;  // sum of V W over sediment and walls [-]
  };
  Record* records;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT&, const LaneT& f, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    const L value = f.volume * g.W;
    const L weight = lane_select(is_water(f), value, L(0.0F));
    sum.bed += value - weight;
    sum.water.weight += weight;
    sum.water.pressure +=
        weight * (f.pressure + L(this->scene.water_density) * (L(1.0F) + f.excess) * gravity_dot(this->scene, g.r));
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    Record& r = records[i];
    const bool of_bed =
        r.kind == kind::deposit || r.kind == kind::bed_load || (this->scene.bed_load.holds_surface && is_resting(r));
    if (!of_bed || !(sum.water.weight > 0)) return;
    const float held = held_share(sum.bed - r.volume * this->scene.kernel.value(1.0F));
    const float difference = this->pressure(sum.water) - r.work[0];
    r.work[0] += held * share_of_lent(difference, head_of_spacing()) * difference;
  }

  /// Pressure of a spacing of water [Pa].
  [[nodiscard]] HOST_DEVICE float head_of_spacing() const {
    const Scene<Dim>& in = this->scene;
    return in.water_density * sqrtf(dot(in.gravity, in.gravity)) * static_cast<float>(in.spacing);
  }
};

/// Brings the lent pressures to the work quads.
template <int Dim, class Device>
void lend_pressure(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  Record* records = p.record.data();
  on.for_each(p.fluid_count, declare<Reads<field::flow>, Writes<field::lent_pressure>>(
                                 [=] HOST_DEVICE(Index i) { records[i].work[0] = records[i].pressure; }));
  sweep(on, p, scene, p.at_bed_surface(), LentPressureSweep<Dim>{{scene}, records});
}

}  // namespace thalweg
