#pragma once

#include <cstdint>

#include "common/particles.hpp"
#include "solver/models/bed/arrays.hpp"
#include "solver/models/bed_load/arrays.hpp"
#include "solver/models/states/arrays.hpp"
#include "solver/models/suspended_load/arrays.hpp"
#include "solver/models/suspended_load/scene.hpp"
#include "solver/passes/sweep.hpp"

// Water that becomes bed and bed that becomes water, before the lists are made anew: these sort clusters by what is in
// them. Grains are kept to the last bit; the volume of a particle stays.
namespace thalweg {

namespace bed_change {
/// Of the grains of a packed particle: with so many more, a particle of the bed makes another one over it.
inline constexpr float most_surplus = 0.5F;
/// Of a packed bed's concentration: water that holds so much and touches a bed or a wall is bed.
inline constexpr float packed_share = 0.75F;
/// Of the grains of a packed particle: with so few left, a particle of the bed is water.
inline constexpr float least_left = 0.02F;
/// Of the spacing: how far particles lie apart that touch.
inline constexpr float touch = 1.4F;
}  // namespace bed_change

/// Volume of grains in a packed particle with the volume of particle i [m^dim].
template <int Dim>
HOST_DEVICE inline double packed_grains(const Scene<Dim>& scene, const Record& r, float mass) {
  return double(scene.suspended_load.packing) * double(mass) / double(scene.density_at_rest(r.kind));
}

/// Particle pass: the water that each particle of the bed with too many grains gives them to, the one nearest to it; and
/// water that is packed, which keeps its own. By their ids, as the giver and the receiver may be on two ranks.
template <int Dim>
struct ReceiverPass {
  using neighbours = Neighbours<field::place, field::matter, field::own_id>;
  using reads = Reads<field::place, field::matter, field::mass, field::grains, field::own_id>;
  using writes = Writes<field::receiver>;

  const Record* records;
  const float* mass;
  const double* grains;
  const std::int64_t* own_id;
  std::int64_t* receiver;
  ClusterList list;
  Scene<Dim> scene;

  HOST_DEVICE void operator()(Index i) const {
    receiver[i] = no_particle;
    const Record& r = records[i];
    if (r.volume == 0) return;
    const double packed = packed_grains(scene, r, mass[i]);
    const bool water = is_water(r);
    const double needed = water ? bed_change::packed_share : bed_change::most_surplus;
    if (!(grains[i] > needed * packed)) return;
    const float reach = bed_change::touch * static_cast<float>(scene.spacing);
    float nearest2 = reach * reach;
    const Index cluster = list.cluster_of(i);
    for (Index e = list.begin[cluster]; e < list.begin[cluster + 1]; ++e) {
      const Index j = list.entries[e];
      if (j == list.none || records[j].volume == 0 || is_water(records[j]) == water) continue;
      if (!water && !is_water(records[j])) continue;
      const Vec<Dim, float> to = scene.separation(records[j].place, r.place);
      const float r2 = dot(to, to);
      if (r2 < nearest2) nearest2 = r2, receiver[i] = own_id[water ? i : j];
    }
  }
};

/// Particle pass over the water: what receives grains, or is packed, becomes a particle of the bed, with the grains that
/// it has and gets, less those of a packed one.
template <int Dim>
struct BecomeBedPass {
  using neighbours = Neighbours<field::receiver, field::grains>;
  using reads = Reads<field::matter, field::mass, field::receiver, field::grains, field::own_id>;
  using writes = Writes<field::place, field::matter, field::mass, field::type, field::grains, field::sediment,
                        field::bed, field::drift>;

  Record* records;
  float* mass;
  std::uint8_t* type;
  double* grains;
  const std::int64_t* own_id;
  const std::int64_t* receiver;
  Sediment* sediment;
  BedSurface* bed;
  Drift* drift;
  ClusterList list;
  Scene<Dim> scene;

  HOST_DEVICE void operator()(Index i) const {
    Record& r = records[i];
    if (!is_water(r) || r.volume == 0) return;
    double received = 0;
    bool becomes_bed = receiver[i] == own_id[i];
    const Index cluster = list.cluster_of(i);
    for (Index e = list.begin[cluster]; e < list.begin[cluster + 1]; ++e) {
      const Index j = list.entries[e];
      if (j == list.none || j == i || receiver[j] != own_id[i]) continue;
      received += grains[j];
      becomes_bed = true;
    }
    if (!becomes_bed) return;
    grains[i] += received - packed_grains(scene, r, mass[i]);
    const float heavier = scene.sediment_density / scene.water_density;
    mass[i] *= heavier;
    r.excess /= heavier;  // the pressure stays: the sound speed is the same
    r.kind = kind::deposit;
    type[i] = static_cast<std::uint8_t>(ParticleType::sediment);
    sediment[i] = {};
    bed[i] = {};
    if (drift != nullptr) drift[i] = {};
  }
};

/// Particle pass over the bed: those that gave grains away have what is packed; one that has lost its grains is water, with
/// the few that are left.
template <int Dim>
struct LeaveBedPass {
  using reads = Reads<field::place, field::matter, field::mass, field::receiver, field::grains, field::own_id>;
  using writes = Writes<field::matter, field::mass, field::type, field::grains>;

  Record* records;
  float* mass;
  std::uint8_t* type;
  double* grains;
  const std::int64_t* own_id;
  const std::int64_t* receiver;
  Scene<Dim> scene;

  HOST_DEVICE void operator()(Index i) const {
    Record& r = records[i];
    if (!is_sediment(r) || r.volume == 0) return;
    if (receiver[i] != no_particle && receiver[i] != own_id[i]) grains[i] = 0;
    const double packed = packed_grains(scene, r, mass[i]);
    const double left = grains[i] + packed;
    if (left > bed_change::least_left * packed) return;
    grains[i] = left;
    const float lighter = scene.water_density / scene.sediment_density;
    mass[i] *= lighter;
    r.excess /= lighter;
    r.kind = kind::water;
    r.viscosity = scene.water_viscosity;
    type[i] = static_cast<std::uint8_t>(ParticleType::water);
  }
};

/// True if particles become of another kind before the step of this number. They do where the lists are made anew, which in
/// still water is hardly ever.
constexpr bool is_bed_change_due(std::int64_t step) {
  constexpr std::int64_t interval = 100;  // steps
  return step % interval == 0;
}

/// Turns water into bed and bed into water. The lists are old, and have to be made anew next.
template <int Dim, class Device>
void change_bed(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  on.fill(p.own_id, p.with_copies(), no_particle);
  on.fill(p.receiver, p.with_copies(), no_particle);  // of walls too
  const std::int64_t* ids = p.id.data();
  std::int64_t* own_id = p.own_id.data();
  on.for_each(p.fluid_count,
              declare<Reads<field::id>, Writes<field::own_id>>([=] HOST_DEVICE(Index i) { own_id[i] = ids[i]; }));
  const ClusterList list = p.list();
  using Receive = ReceiverPass<Dim>;
  const Receive receive{p.record.data(), p.mass.data(), p.grains.data(), own_id, p.receiver.data(), list, scene};
  on.for_each(p.fluid_count, declare<typename Receive::neighbours, typename Receive::reads, typename Receive::writes>(
                                 [=] HOST_DEVICE(Index i) { receive(i); }));
  using Become = BecomeBedPass<Dim>;
  Drift* drift = scene.bed_load.on ? p.drift.data() : nullptr;
  const Become become{p.record.data(),
                      p.mass.data(),
                      p.type.data(),
                      p.grains.data(),
                      own_id,
                      p.receiver.data(),
                      p.sediment.data(),
                      p.bed.data(),
                      drift,
                      list,
                      scene};
  on.for_each(p.fluid_count, declare<typename Become::neighbours, typename Become::reads, typename Become::writes>(
                                 [=] HOST_DEVICE(Index i) { become(i); }));
  on.for_each(p.fluid_count, LeaveBedPass<Dim>{p.record.data(), p.mass.data(), p.type.data(), p.grains.data(), own_id,
                                               p.receiver.data(), scene});
  // Ranks exchange arrays as long as their particles, and nobody needs these before the next change.
  p.own_id.resize(0);
  p.receiver.resize(0);
}

}  // namespace thalweg
