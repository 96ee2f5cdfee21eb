#pragma once

#include <cstdint>

#include "physics/vec.hpp"
#include "solver/state/field.hpp"

namespace thalweg {

using Index = std::uint32_t;

/// The kind of a particle. The signs make two tests cheap in a pair sum: two particles are of one phase if the product
/// of their kinds is positive, and a wall is 0. A float, because a small integer in a float lane is a denormal, which
/// some devices compare equal to zero.
namespace kind {
inline constexpr float water = -1;
inline constexpr float wall = 0;
inline constexpr float deposit = 1;    // sediment that obeys the yield criterion; SedimentState of common/particles.hpp
inline constexpr float bed_load = 2;   // sediment that the water's shear stress moves along the bed
inline constexpr float suspended = 3;  // sediment that the water carries
inline constexpr float resting = 4;    // a deposit that has stopped exactly; its neighbours take it for a wall
}  // namespace kind

/// The part of a particle that pair sweeps read: 64 bytes, one cache line, four quads (quad_place …).
/// `place` counts quanta of the domain's extent (state/lattice.hpp), so that differences are exact in 32 bits and wrap
/// around periodic directions by themselves; the position proper is kept in double beside it.
struct alignas(64) Record {
  std::int32_t place[3];  // [quanta]
  float volume;           // [m^dim]; 0 takes the particle out of every sum
  float velocity[3];      // [m/s]
  float pressure;         // [Pa]
  float excess;           // rho/rho0 - 1 [-]; of a wall: share of sediment in the fluid it continues [-]
  float viscosity;        // [Pa s]
  float kind;             // kind::water …
  float dissipation;      // share of the artificial viscosity that acts on it [-]
  float work[4];          // scratch of one pass after the other; its meanings are fields (field::…) of the models
};
static_assert(sizeof(Record) == 64);

/// The record of a sweep that needs nothing but the work quad: four of them share a cache line.
struct alignas(16) Vectors {
  float work[4];
};

/// True for water, for sediment, for walls; of a record or of a lane (one truth a lane).
template <class R>
HOST_DEVICE inline auto is_water(const R& r) {
  return r.kind < decltype(r.kind)(-0.5F);
}
template <class R>
HOST_DEVICE inline auto is_sediment(const R& r) {
  return r.kind > decltype(r.kind)(0.5F);
}
template <class R>
HOST_DEVICE inline auto is_wall(const R& r) {
  return r.kind == decltype(r.kind)(kind::wall);
}
/// True for sediment at rest.
template <class R>
HOST_DEVICE inline auto is_resting(const R& r) {
  return r.kind > decltype(r.kind)(3.5F);
}
/// True if both are water or both are sediment.
template <class R>
HOST_DEVICE inline auto same_phase(const R& a, const R& b) {
  return a.kind * b.kind > decltype(a.kind)(0.0F);
}

/// One record in lanes: L is float (one pair at a time) or a pack (several), I the matching integer.
template <int Dim, class L, class I>
struct Lane {
  Vec<Dim, I> place;
  L volume;
  Vec<Dim, L> velocity;
  L pressure;
  L excess;
  L viscosity;
  L kind;
  L dissipation;
  Vec<Dim, L> work;
};

/// The layout of a Record's members in its quads. Both backends fill lanes by it: `read` has place(quad, vector),
/// vector(quad, vector) and number(quad, entry, number), with quad and entry as template arguments.
template <int Dim, unsigned quads, class LaneT, class Read>
HOST_DEVICE inline void read_lane(LaneT& lane, const Read& read) {
  read.template place<0>(lane.place);
  read.template number<0, 3>(lane.volume);
  if constexpr ((quads & quad_flow) != 0) {
    read.template vector<1>(lane.velocity);
    read.template number<1, 3>(lane.pressure);
  }
  if constexpr ((quads & quad_matter) != 0) {
    read.template number<2, 0>(lane.excess);
    read.template number<2, 1>(lane.viscosity);
    read.template number<2, 2>(lane.kind);
    read.template number<2, 3>(lane.dissipation);
  }
  if constexpr ((quads & quad_work) != 0) read.template vector<3>(lane.work);
}

}  // namespace thalweg
