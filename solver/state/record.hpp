#pragma once

#include <cstdint>

#include "physics/vec.hpp"

namespace thalweg {

using Index = std::uint32_t;

/// What a particle is to the pair sums; a float in the record because a small integer in a float lane is a denormal,
/// which some devices compare equal to zero.
inline constexpr float phase_wall = 0;
inline constexpr float phase_water = 1;
inline constexpr float phase_sediment = 2;

/// What a sediment particle is doing: SedimentState of common/particles.hpp as a float, and `resting`: a deposit that
/// has come to rest exactly and is to its neighbours what a wall is (models/rest/rest.hpp).
inline constexpr float state_none = 0;
inline constexpr float state_deposit = 1;
inline constexpr float state_bed_load = 2;
inline constexpr float state_suspended = 3;
inline constexpr float state_resting = 4;

/// What a pair sweep reads of a particle: 64 bytes, one cache line, four quads (solver/backend/openmp.hpp loads quads).
/// `place` counts quanta of the domain's extent (Lattice in scene.hpp), so that differences are exact in 32 bits and
/// wrap around periodic directions by themselves; the position proper is kept in double beside it.
struct alignas(64) Record {
  std::int32_t place[3];  // [quanta]
  float volume;           // [m^dim]; 0 takes the particle out of every sum
  float velocity[3];      // [m/s]
  float pressure;         // [Pa]
  float excess;           // rho/rho0 - 1 [-]; of a wall: share of sediment in the fluid it continues [-]
  float viscosity;        // [Pa s]
  float phase;            // phase_wall, phase_water, phase_sediment
  float state;            // state_none (no sediment), state_deposit …
  float work[4];          // a vector of the implicit viscous solve
};
static_assert(sizeof(Record) == 64);

/// What a sweep reads of a particle in place of a record if the vectors of an iteration are all it needs: four of them
/// share a cache line.
struct alignas(16) Vectors {
  float work[4];
};

/// Quads of a record a sweep can ask for.
enum Quads : unsigned { quad_place = 1, quad_motion = 2, quad_matter = 4, quad_work = 8 };

HOST_DEVICE inline bool is_resting(const Record& r) { return r.state == state_resting; }

/// One record in lanes: L is float (one pair at a time) or a pack (several), I the matching integer.
template <int Dim, class L, class I>
struct Lane {
  Vec<Dim, I> place;
  L volume;
  Vec<Dim, L> velocity;
  L pressure;
  L excess;
  L viscosity;
  L phase;
  L state;
  Vec<Dim, L> work;
};

/// The geometry of one pair, computed once for every body: r = x_a - x_b [m] and r^2 [m^2].
template <int Dim, class L>
struct Separation {
  Vec<Dim, L> r;
  L r2;
};

}  // namespace thalweg
