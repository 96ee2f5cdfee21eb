#pragma once

#include <cmath>

#include "physics/transport/wall_stress.hpp"
#include "solver/models/states/arrays.hpp"
#include "solver/passes/sweep.hpp"

// The surface of the bed around a particle. It is found from the sediment alone, its normal from the gradient of the
// sediment's concentration, the velocity over it from the mean of the water in reach (docs/theory.md, "Three states").
namespace thalweg {

/// Pair sweep over the clusters that have sediment and water in reach: what each sediment particle's surroundings are.
template <int Dim>
struct BedSurfaceSweep {
  using neighbours = Neighbours<field::place, field::flow, field::matter>;
  using reads = Reads<field::place, field::flow, field::matter>;
  using writes = Writes<field::bed>;
  static constexpr unsigned kernel = kernel_value | kernel_gradient;
  template <class L>
  struct Sum {
    L fill;
    L sediment_volume;
    L fluid_volume;
    Vec<Dim, L> gradient;  // of the sediment's concentration, or less that of the water's
    L water_share;
    Vec<Dim, L> water_velocity;
    Vec<Dim, L> water_offset;
    L water_second[Dim * (Dim + 1) / 2];  // of V W r (x) r of water, upper triangle row by row
    L deposit_share;
    Vec<Dim, L> deposit_velocity;
    L settled_share;
  };

  const Record* records;
  BedSurface* bed;
  Scene<Dim> scene;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT&, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    const L zero(0.0F);
    const L weight = b.volume * g.W;
    const L slope = b.volume * g.F;
    const L inside = lane_select(g.F < zero, b.volume, zero);

    const auto b_wall = is_wall(b);
    const auto b_sediment = is_sediment(b);
    // A wall continues what lies before it: without it the grains along a wall would have a surface towards it.
    const L share = lane_select(b_wall, b.excess, lane_select(b_sediment, L(1.0F), zero));
    sum.fill += share * weight;
    const L sediment_weight = lane_select(b_sediment, weight, zero);
    sum.sediment_volume += lane_select(b_sediment, inside, zero);
    sum.fluid_volume += lane_select(b_wall, zero, inside);
    const L water_weight = lane_select(b_wall, zero, weight) - sediment_weight;
    // Bed load that drifts along the surface takes the normal of the water's concentration: that of the sediment's
    // leans away from grains that have come close to each other, which then climb on each other's backs.
    const L sediment_slope = L(scene.erosion.by_law ? 0.0F : 1.0F) * share * slope +
                             L(scene.erosion.by_law ? -1.0F : 0.0F) * (L(1.0F) - share) * slope;
    sum.water_share += water_weight;
    const L settled = lane_select(b.kind == L(kind::suspended), zero, sediment_weight);
    const L deposit = lane_select(b.kind == L(kind::bed_load), zero, settled);
    sum.settled_share += settled;
    sum.deposit_share += deposit;
    int m = 0;
    for (int k = 0; k < Dim; ++k) {
      sum.gradient[k] += sediment_slope * g.r[k];
      sum.water_velocity[k] += water_weight * b.velocity[k];
      const L offset = water_weight * g.r[k];
      sum.water_offset[k] += offset;
      for (int l = k; l < Dim; ++l) sum.water_second[m++] += offset * g.r[l];
      sum.deposit_velocity[k] += deposit * b.velocity[k];
    }
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    const Record& r = records[i];
    if (!is_sediment(r)) return;
    BedSurface& s = bed[i];
    const float own = r.volume * scene.kernel.value(1.0F);
    s.fill = sum.fill;
    s.concentration = sum.sediment_volume / sum.fluid_volume;
    s.water_share = sum.water_share;
    s.settled_share = sum.settled_share - (r.kind == kind::suspended ? 0 : own);
    // A particle does not hold itself.
    const bool deposit = r.kind == kind::deposit || is_resting(r);
    const float deposits = sum.deposit_share - (deposit ? own : 0);
    const bool has_deposits = deposits > 1e-3F;  // [-] of a full bed
    float length = 0;
    for (int k = 0; k < Dim; ++k) length += sum.gradient[k] * sum.gradient[k];
    length = sqrtf(length);
    // A grain by itself has no surface: its normal is upwards.
    const bool has_surface = length * static_cast<float>(scene.smoothing_length) > 0.01F;
    float height = 0;
    for (int k = 0; k < Dim; ++k) {
      const int c = axis<Dim>(k);
      s.normal[c] = has_surface ? -sum.gradient[k] / length : -scene.erosion.down[k];
      s.water_velocity[c] = sum.water_share > 0 ? sum.water_velocity[k] / sum.water_share : 0;
      if (sum.water_share > 0) height -= s.normal[c] * sum.water_offset[k] / sum.water_share;
      const float of_others = sum.deposit_velocity[k] - (deposit ? own * r.velocity[c] : 0);
      s.bed_velocity[c] = has_deposits ? of_others / deposits : 0;
    }
    set_heights(s, sum, height);
  }

  /// Height of a particle that stands out over the bed around it [m]. One that lies in the flat has the layers above it
  /// in reach; one a spacing higher, water in its own layer, too.
  [[nodiscard]] HOST_DEVICE float rise_over_bed(float water_share) const {
    const float rise = scene.erosion.rise_of_share * (water_share - scene.erosion.share_over_flat);
    const auto most = 2 * static_cast<float>(scene.spacing);
    return rise < 0 ? 0 : rise < most ? rise : most;
  }

  /// Mean and log-mean height of the water over the bed, whose surface lies half a spacing above the particle's centre;
  /// `height`: mean over the centre [m]. Below a particle that stands out the bed lies lower: heights over its own back
  /// are near 0, as much of the water in reach is beside it, and with them it felt three to six times the bed's stress.
  HOST_DEVICE void set_heights(BedSurface& s, const Sum<float>& sum, float height) const {
    const auto dp = static_cast<float>(scene.spacing);
    s.water_height = height - 0.5F * dp + (scene.erosion.by_law ? rise_over_bed(sum.water_share) : 0.0F);
    s.log_height = 0;
    if (!(sum.water_share > 0)) return;
    float square = 0;
    int m = 0;
    for (int k = 0; k < Dim; ++k) {
      for (int l = k; l < Dim; ++l) {
        square += (k == l ? 1.0F : 2.0F) * s.normal[axis<Dim>(k)] * s.normal[axis<Dim>(l)] * sum.water_second[m++];
      }
    }
    const float variance = square / sum.water_share - height * height;
    const float mean = s.water_height > 0.1F * dp ? s.water_height : 0.1F * dp;
    s.log_height = log_mean_height(mean, variance > 0 ? variance : 0.0F);
  }
};

/// Particle pass for bed_shear = nearest: the water particle closest to each grain in place of the mean.
template <int Dim>
struct NearestWaterPass {
  using neighbours = Neighbours<field::place, field::flow, field::matter>;
  using reads = Reads<field::bed>;
  using writes = Writes<field::bed>;

  const Record* records;
  BedSurface* bed;
  ClusterList list;
  Scene<Dim> scene;

  HOST_DEVICE void operator()(Index i) const {
    if (!is_sediment(records[i]) || !(bed[i].water_share > 0)) return;
    float nearest2 = scene.support() * scene.support();
    Index nearest = list.none;
    const Index cluster = list.cluster_of(i);
    for (Index e = list.begin[cluster]; e < list.begin[cluster + 1]; ++e) {
      const Index j = list.entries[e];
      if (!is_water(records[j])) continue;
      const Vec<Dim, float> r = scene.separation(records[j].place, records[i].place);
      const float r2 = dot(r, r);
      if (r2 < nearest2) nearest2 = r2, nearest = j;
    }
    if (nearest == list.none) return;
    for (int c = 0; c < 3; ++c) bed[i].water_velocity[c] = records[nearest].velocity[c];
    bed[i].water_height = sqrtf(nearest2);
  }
};

}  // namespace thalweg
