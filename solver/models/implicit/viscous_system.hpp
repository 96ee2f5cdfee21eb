#pragma once

#include <cmath>
#include <type_traits>

#include "physics/lane_math.hpp"
#include "solver/state/particles.hpp"
#include "solver/state/step_state.hpp"

namespace thalweg {

namespace field {
/// The work quad during the viscous solve: the vector u, and the particle's own mass.
inline constexpr Field viscous_vector{"ViscousVector", quad_work};
/// The same in an array of its own, if the pair coefficients are stored.
inline constexpr Field viscous_vectors{"ViscousVectors"};
}  // namespace field

/// A particle's row of the system.
struct ViscousRow {
  float residual[3];   // r [kg m/s]
  float diagonal;      // [kg]
  float product[3];    // A u, u = r/diagonal (IterationVector) [kg m/s]
  float direction[3];  // p [m/s]
  float along[3];      // A p [kg m/s]
  float increment[3];  // of the velocity [m/s]
};

/// Arrays of the solve, kept between steps.
template <class Device>
struct ViscousSystem {
  template <class T>
  using Buffer = typename Device::template Buffer<T>;
  using Row = ViscousRow;
  Buffer<typename Device::PairCoefficient> coefficient;  // k_ab [kg/s], one a pair, in the order of the lists
  Buffer<Vectors> vectors;                               // u of all particles, if the coefficients are kept
  Buffer<Row> row;
};

/// The field of the CG vector u.
template <bool stored>
using VectorField = std::conditional_t<stored, Fields<field::viscous_vectors>, Fields<field::viscous_vector>>;

/// Storage of the CG vector u: an array of its own if the pair coefficients are stored, else the records' work quad.
/// A fourth number follows the three components: the particle's mass plus what the walls' surfaces add to the diagonal
/// [kg].
template <bool stored>
struct IterationVector {
  using InField = VectorField<stored>;
  using From = std::conditional_t<stored, Vectors, Record>;
  From* from;
  HOST_DEVICE float* operator[](Index i) const { return from[i].work; }
};
inline constexpr int own_mass = 3;
template <bool stored, class Device>
IterationVector<stored> iteration_vector(Particles<Device>& p, ViscousSystem<Device>& system) {
  if constexpr (stored) {
    return {system.vectors.data()};
  } else {
    return {p.record.data()};
  }
}

namespace viscosity {

HOST_DEVICE inline double dot3(const float* a, const float* b) {
  return double(a[0]) * double(b[0]) + double(a[1]) * double(b[1]) + double(a[2]) * double(b[2]);
}

/// Sums over particles that the iteration needs.
struct Norms {
  double preconditioned = 0;  // r . r / diagonal
  double squared = 0;         // r . r
  double momentum = 0;        // square of the force of gravity and the present accelerations [kg m/s^2]
};
struct AddNorms {
  HOST_DEVICE Norms operator()(const Norms& a, const Norms& b) const {
    return {a.preconditioned + b.preconditioned, a.squared + b.squared, a.momentum + b.momentum};
  }
};

template <class Row>
HOST_DEVICE Norms norms_of(const Row& row) {
  const double squared = dot3(row.residual, row.residual);
  return {squared / double(row.diagonal), squared, 0};
}

}  // namespace viscosity

namespace viscosity {

/// Decides whether the iteration is over; `squared` is the residual's square.
HOST_DEVICE inline void judge(ViscousState& v, double squared, double tolerance, int most_iterations) {
  v.residual = v.scale > 0 ? std::sqrt(squared) / v.scale : 0;
  v.converged = v.residual <= tolerance ? 1 : 0;
  v.running = v.converged == 0 && v.iterations < most_iterations && std::isfinite(v.residual) ? 1 : 0;
}

}  // namespace viscosity

}  // namespace thalweg
