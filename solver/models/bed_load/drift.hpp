#pragma once

#include <cmath>

#include "physics/transport/bed_load_drift.hpp"
#include "physics/transport/slope_effect.hpp"
#include "solver/models/bed_load/arrays.hpp"
#include "solver/models/bed_load/drag.hpp"
#include "solver/models/bed_load/lone_parcels.hpp"
#include "solver/models/bed_load/scene.hpp"
#include "solver/models/states/bed_states.hpp"
#include "solver/passes/integrate.hpp"

// The drift of bed load over the skeleton that it lies on. A record's velocity is the skeleton's, which yields like a
// deposit; places move, and densities change, with velocity plus drift.
namespace thalweg {

/// Particle pass: the drift of the sediment, into the work quad. A parcel in suspension sinks (sink()). The row of an inlet
/// has the drift that the inlet gives it. Bed load over the surface of the bed has u_d, from that of the last step:
///   target   q_b(theta, theta_cr)/((1 - n) dp) along the water's velocity over the bed (bed_load_drift.hpp)
///   u_d      (1 - f) target + f sum_b w u_d,b/sum_b w,  w = V_b W (r.e)+ over the surface upstream, where a bed that
///            does not move, or a wall, sends nothing;  f = L/(L + l),  l = sum w (r.e)/sum w
/// L the saturation length: the load adapts to the bed that it comes to over L. Without it waves of drift 7 to 14 dp long
/// grow and tear the surface.
///   sideways in space, sqrt(theta_cr/theta) 1.5 times the slope across the flow goes with it downhill (transverse_slope())
///   evening  u_d loses 2 h |u_d| grad_t C, at most half of itself, C the concentration of bed load
template <int Dim>
struct BedLoadDriftPass {
  using neighbours = Neighbours<field::place, field::matter, field::drift, field::bed>;
  using reads = Reads<field::place, field::flow, field::matter, field::bed, field::role>;
  using writes = Writes<field::drift_velocity>;

  Record* records;
  const BedSurface* bed;
  const Drift* drift;
  const Role* roles;  // nullptr without openings
  ClusterList list;
  Scene<Dim> scene;

  HOST_DEVICE void operator()(Index i) const {
    Record& r = records[i];
    if (r.volume == 0) return;
    if (roles != nullptr && roles[i] == Role::prescribed) {
      for (int c = 0; c < 3; ++c) r.work[c] = drift[i].velocity[c];
      return;
    }
    const BedSurface& s = bed[i];
    if (is_in_suspension(r, s)) return sink(i, s);
    if (r.kind != kind::bed_load) return;
    if (!(s.shear_stress > s.critical_stress)) return;
    const Vec<Dim, float> u = speed_along_bed<Dim>(r, s);
    const float speed = sqrtf(dot(u, u));
    if (!(speed > 0)) return;
    const Vec<Dim, float> e = (1 / speed) * u;
    const Around up = look_around(i, e);
    const Vec<Dim, float> n = mean_normal(s, up);
    const Vec<Dim, float> along_flow = along_surface(e, n);
    const Vec<Dim, float> along_bed = downhill(s, along_flow, n);
    const float target = target_drift(s, along_flow, speed);
    float along = target;
    if (up.weight > 0) {
      const float distance = up.distance / up.weight;
      const float kept = scene.bed_load.saturation / (scene.bed_load.saturation + distance);
      along = (1 - kept) * target + kept * up.drift / up.weight;
    }
    if (along > speed) along = speed;
    if (!(along > 0)) return;
    Vec<Dim, float> drifts = along * along_bed;
    const Vec<Dim, float> even = up.gradient - dot(up.gradient, n) * n;
    const float h2 = 2 * static_cast<float>(scene.smoothing_length);
    const float most = 0.5F / (h2 * sqrtf(dot(even, even)) + 1e-30F);
    const float share = h2 * along * (most < 1 ? most : 1);
    for (int k = 0; k < Dim; ++k) drifts[k] -= share * even[k];
    for (int k = 0; k < Dim; ++k) r.work[axis<Dim>(k)] = drifts[k];
  }

 private:
  /// A parcel in suspension sinks through the water at the settling velocity of its grains, less where it comes to a bed
  /// or to a wall: past a wall that it did not see, it sank in by more than a spacing.
  HOST_DEVICE void sink(Index i, const BedSurface& s) const {
    Record& r = records[i];
    const float room = 1 - (s.settled_share + share_of_walls(i)) / settling::landed;
    if (!(room > 0)) return;
    // Around a parcel that sinks by itself the water that makes room for it rises, and takes it along.
    const float against = settling::counterflow<Dim> * lone_share(r, s, scene.kernel.value(1.0F));
    const float speed = (1 - 1 / settling::tie + against) * scene.erosion.settling_velocity * room;
    for (int k = 0; k < Dim; ++k) r.work[axis<Dim>(k)] = speed * scene.erosion.down[k];
  }

  /// Sum of V W over the walls in reach [-].
  [[nodiscard]] HOST_DEVICE float share_of_walls(Index i) const {
    float share = 0;
    const Index cluster = list.cluster_of(i);
    for (Index entry = list.begin[cluster]; entry < list.begin[cluster + 1]; ++entry) {
      const Index j = list.entries[entry];
      if (j == list.none || !is_wall(records[j])) continue;
      const Vec<Dim, float> r = scene.separation(records[i].place, records[j].place);
      const float r2 = dot(r, r);
      if (!(r2 < scene.support() * scene.support())) continue;
      share += records[j].volume * scene.kernel.value(scene.kernel.closeness(sqrtf(r2)));
    }
    return share;
  }

  struct Around {
    float weight = 0;            // sum of w [m]
    float distance = 0;          // of w (r.e) [m^2]
    float drift = 0;             // of w u_d.e [m^2/s]
    Vec<Dim, float> gradient{};  // of the concentration of bed load [1/m]
    Vec<Dim, float> normal{};    // sum of V W n
  };

  HOST_DEVICE Around look_around(Index i, const Vec<Dim, float>& e) const {
    Around up;
    const Vec<Dim, float> own_normal = bed_states::pick<Dim>(bed[i].normal);
    const float support = scene.support();
    const Index cluster = list.cluster_of(i);
    for (Index entry = list.begin[cluster]; entry < list.begin[cluster + 1]; ++entry) {
      const Index j = list.entries[entry];
      if (j == list.none || records[j].volume == 0) continue;
      const bool load = records[j].kind == kind::bed_load;
      const bool fixed = is_wall(records[j]) || records[j].kind == kind::deposit || is_resting(records[j]);
      if (!load && !fixed) continue;
      const Vec<Dim, float> r = scene.separation(records[i].place, records[j].place);
      const float r2 = dot(r, r);
      if (!(r2 < support * support)) continue;
      const float t = scene.kernel.closeness(sqrtf(r2));
      const float share = records[j].volume * scene.kernel.value(t);
      if (load) {
        const Vec<Dim, float> n = bed_states::pick<Dim>(bed[j].normal);
        const float slope = records[j].volume * scene.kernel.gradient(t);
        for (int k = 0; k < Dim; ++k) {
          up.normal[k] += share * n[k];
          up.gradient[k] += slope * r[k];
        }
      }
      const float ahead = dot(r, e);
      if (!(ahead > 0)) continue;
      // A bed below the surface says nothing of the load that comes along it.
      if (fixed && !(fabsf(dot(r, own_normal)) < 0.75F * static_cast<float>(scene.spacing))) continue;
      const float w = share * ahead;
      up.weight += w;
      up.distance += w * ahead;
      if (load) up.drift += w * dot(bed_states::pick<Dim>(drift[j].velocity), e);
    }
    return up;
  }

  /// The normal of the bed around a particle, from those of the bed load in reach: single grains are no slope.
  [[nodiscard]] HOST_DEVICE static Vec<Dim, float> mean_normal(const BedSurface& s, const Around& around) {
    const float length = sqrtf(dot(around.normal, around.normal));
    return length > 0 ? (1 / length) * around.normal : bed_states::pick<Dim>(s.normal);
  }

  /// The unit vector closest to e along the surface of the normal n.
  [[nodiscard]] HOST_DEVICE static Vec<Dim, float> along_surface(const Vec<Dim, float>& e, const Vec<Dim, float>& n) {
    const Vec<Dim, float> along = e - dot(e, n) * n;
    const float length = sqrtf(dot(along, along));
    return length > 0.1F ? (1 / length) * along : e;
  }

  /// The direction of the load from that of the flow along a surface of the normal n.
  [[nodiscard]] HOST_DEVICE Vec<Dim, float> downhill(const BedSurface& s, const Vec<Dim, float>& e,
                                                     const Vec<Dim, float>& n) const {
    if constexpr (Dim == 2) {
      return e;
    } else {
      const Vec<Dim, float>& down = scene.erosion.down;
      const float cosine = -dot(n, down);
      if (!(cosine > 0.1F)) return e;
      // Along the surface and across the flow; its length is the slope there.
      Vec<Dim, float> across = (1 / cosine) * (down - dot(down, n) * n);
      across = across - dot(across, e) * e;
      return along_surface(e + transverse_slope(s.critical_stress / s.shear_stress) * across, n);
    }
  }

  [[nodiscard]] HOST_DEVICE float target_drift(const BedSurface& s, const Vec<Dim, float>& e, float speed) const {
    const BedLoadConstants& law = scene.bed_load;
    const ErosionScene<Dim>& grains = scene.erosion;
    const float flux = law.scale * bed_load(law.law, s.shear_stress / grains.grain_weight,
                                            s.critical_stress / grains.grain_weight, grains.dimensionless_diameter);
    const float sine = -dot(e, grains.down);
    const float cosine2 = 1 - sine * sine;
    const float rise = cosine2 > 1e-6F ? sine / sqrtf(cosine2) : 0;
    const float least = 0.01F;  // [-] of the friction: a bed without any has no slope to climb
    const float friction = scene.sediment.friction_tangent > least ? scene.sediment.friction_tangent : least;
    return bed_load_drift(flux * bed_load_slope_factor(law.slope_effect, rise, friction), law.layer, speed);
  }
};

/// Finds the drift of all bed load for the motion that follows: in the work quad, 0 of all else, and in p.drift.
template <int Dim, class Device>
void find_drift(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  Record* records = p.record.data();
  Drift* drift = p.drift.data();
  on.for_each(p.count, declare<Reads<>, Writes<field::drift_velocity>>([=] HOST_DEVICE(Index i) {
                for (float& w : records[i].work) w = 0;
              }));
  const BedLoadDriftPass<Dim> pass{records, p.bed.data(), drift, p.roles(), p.list(), scene};
  using Pass = BedLoadDriftPass<Dim>;
  on.for_each(p.fluid_count, declare<typename Pass::neighbours, typename Pass::reads, typename Pass::writes>(
                                 [=] HOST_DEVICE(Index i) { pass(i); }));
  on.for_each(p.fluid_count, declare<Reads<field::drift_velocity>, Writes<field::drift>>([=] HOST_DEVICE(Index i) {
                for (int c = 0; c < 3; ++c) drift[i].velocity[c] = records[i].work[c];
              }));
}

}  // namespace thalweg
