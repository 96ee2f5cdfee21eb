#pragma once

#include <cmath>

#include "physics/pair_terms.hpp"
#include "solver/passes/time_step.hpp"

// Implicit viscosity of the sediment and of the layer between water and sediment: solves
//   m_a u_a + dt sum_b k_ab (u_a - u_b) = m_a u*_a
// for the velocities at the end of the step, walls standing still (and dragging as physics/no_slip.hpp says). k_ab =
// k_ba >= 0 makes the system symmetric and positive definite; it is solved by conjugate gradients with Jacobi
// preconditioning on the clusters with sediment in reach. An explicit treatment would need steps 50 to 400 times
// smaller, a cap on the viscosity makes a bed creep (docs/theory.md).
//
// Where the coefficients are kept between iterations, they are so in half a float (ShortFloat): what is solved for is
// the change since the last step, from a residual of full precision, and with each k_ab off by 2^-9 at most, all of
// them positive and k_ab = k_ba to the last bit, the quadratic form of the system is off by no more than that share.
//
// The gradients are those of Chronopoulos & Gear (1989): an iteration is one sweep and one pass, each with its sum, and
// the numbers they exchange stay on the device (ViscousState).
namespace thalweg {

/// Arrays of the solve, kept between steps.
template <class Device>
struct ViscousSystem {
  template <class T>
  using Buffer = typename Device::template Buffer<T>;
  struct Row {
    float residual[3];   // r [kg m/s]
    float diagonal;      // [kg]
    float product[3];    // A u, u = r/diagonal (IterationVector) [kg m/s]
    float direction[3];  // p [m/s]
    float along[3];      // A p [kg m/s]
    float increment[3];  // of the velocity [m/s]
  };
  Buffer<typename Device::PairCoefficient> coefficient;  // k_ab [kg/s], one a pair, in the order of the lists
  Buffer<Vectors> vectors;                               // u of all particles, if the coefficients are kept
  Buffer<Row> row;
};

/// Where the vector u lies that an iteration multiplies by, and behind its three components the mass with what the
/// walls' surfaces add to the diagonal [kg]: in an array of its own if the coefficients are kept, as there is nothing
/// else then that a sweep reads of a neighbour; else in the records' work quad, beside what the coefficients are
/// computed from.
template <bool stored>
struct IterationVector {
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
  double momentum = 0;        // square of what gravity and the present accelerations give per time [kg m/s^2]
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

/// What couples the velocities of two particles in a single-layer bed: the sediment's viscosity, and the layer between
/// water and sediment.
template <int Dim>
struct ViscousCoupling {
  static constexpr unsigned quads = quad_place | quad_motion | quad_matter;
  static constexpr bool needs_stored = false;
  Scene<Dim> scene;

  /// k_ab [kg/s]; u = u_a - u_b. What a wall adds by being behind its surface is not in it (WallDrag).
  template <class LaneT, class L>
  HOST_DEVICE L coefficient(const LaneT& a, const LaneT& b, const Vec<Dim, L>& u, const L& closeness) const {
    const auto a_sediment = a.phase > L(phase_water + 0.5F);
    const auto b_sediment = b.phase > L(phase_water + 0.5F);
    const auto b_wall = b.phase < L(phase_wall + 0.5F);
    const L interface = L(2.0F) * interface_viscosity(L(scene.water_viscosity), L(scene.water_density),
                                                      lane_sqrt(dot(u, u)), L(static_cast<float>(scene.spacing)));
    const L among_sediment = lane_select(b_sediment, a.viscosity + b.viscosity, interface);
    const L of_sediment = lane_select(b_wall, a.viscosity + a.viscosity, among_sediment);
    const L of_water = lane_select(b_sediment, interface, L(0.0F));
    return viscous_coefficient(a.volume, b.volume, lane_select(a_sediment, of_sediment, of_water),
                               scene.kernel.gradient(closeness));
  }
};

/// Pair sweep: the diagonal and the residual of the velocities u in the records, which are the explicit ones u* and a
/// first guess dt v of what viscosity adds: -m_a dt v_a - dt sum k_ab (u_a - u_b). If `stored`, the coefficients k_ab
/// as well.
template <int Dim, bool stored, class Kept, class Row, class Coupling>
struct ViscousCoefficientSweep {
  static constexpr unsigned quads = Coupling::quads;
  template <class L>
  struct Sum {
    L coefficients;
    Vec<Dim, L> exchange;
    WallDrag<Dim, L> walls;
  };

  const Record* records;
  const float* mass;
  const Rates* rates;
  const Sediment* sediment;
  IterationVector<stored> vector;
  Kept* coefficient;
  Row* rows;
  Coupling coupling;
  const StepState* state;

  template <class LaneT, class Sep, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const Sep& s, std::size_t entry, Sum<L>& sum) const {
    const Vec<Dim, L> u = a.velocity - b.velocity;
    const L closeness = coupling.scene.kernel.closeness(lane_sqrt(s.r2));
    const L k = coupling.coefficient(a, b, u, closeness);
    if constexpr (stored) lane_store(coefficient + entry, k);
    sum.coefficients += k;
    for (int c = 0; c < Dim; ++c) sum.exchange[c] += k * u[c];
    sum.walls.add(lane_select(b.phase < L(phase_wall + 0.5F), k, L(0.0F)), s, u);
  }

  /// The sums the iteration starts from.
  HOST_DEVICE viscosity::Norms end(Index i, const Sum<float>& sum) const {
    const auto dt = static_cast<float>(state->step.dt);
    const float more_of_walls = coupling.scene.no_slip.excess(sum.walls);
    const float own = mass[i] + dt * more_of_walls * sum.walls.coefficients;
    vector[i][own_mass] = own;
    Row row{};
    row.diagonal = own + dt * sum.coefficients;
    const float* viscous = sediment[i].viscous_acceleration;
    for (int c = 0; c < Dim && !is_resting(records[i]); ++c) {
      const int k = axis<Dim>(c);
      row.residual[k] = -dt * (mass[i] * viscous[k] + sum.exchange[c] + more_of_walls * sum.walls.exchange[c]);
    }
    rows[i] = row;
    viscosity::Norms norms = viscosity::norms_of(row);
    const double m = mass[i];
    double a2 = viscosity::dot3(rates[i].acceleration, rates[i].acceleration) + viscosity::dot3(viscous, viscous);
    for (int k = 0; k < Dim; ++k) a2 += double(coupling.scene.gravity[k]) * double(coupling.scene.gravity[k]);
    norms.momentum = m * m * a2;
    return norms;
  }
};

/// Pair sweep: A u; the coefficients k_ab as stored, or computed again from the velocities, which stay in the records
/// until the iteration is over. Returns u . A u.
template <int Dim, bool stored, class Kept, class Row, class Coupling>
struct ViscousProductSweep {
  static constexpr unsigned quads = quad_work | Coupling::quads;
  template <class L>
  struct Sum {
    Vec<Dim, L> exchange;
  };

  const Record* records;
  IterationVector<stored> vector;
  const Kept* coefficient;
  Row* rows;
  Coupling coupling;
  const StepState* state;

  template <class LaneT, class Sep, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const Sep& s, std::size_t entry, Sum<L>& sum) const {
    L k;
    if constexpr (stored) {
      lane_load(coefficient + entry, k);
    } else {
      const L closeness = coupling.scene.kernel.closeness(lane_sqrt(s.r2));
      k = coupling.coefficient(a, b, a.velocity - b.velocity, closeness);
    }
    for (int c = 0; c < Dim; ++c) sum.exchange[c] += k * (a.work[c] - b.work[c]);
  }

  HOST_DEVICE double end(Index i, const Sum<float>& sum) const {
    if (is_resting(records[i])) return 0;  // a wall: its velocity is no unknown
    const auto dt = static_cast<float>(state->step.dt);
    const float* u = vector[i];
    for (int c = 0; c < Dim; ++c) {
      rows[i].product[axis<Dim>(c)] = u[own_mass] * u[axis<Dim>(c)] + dt * sum.exchange[c];
    }
    return viscosity::dot3(u, rows[i].product);
  }
};

/// Particle pass: the rest of an iteration, from the A u that the sweep found. Returns the sums of the new residual.
template <class Row, class Vector>
struct ViscousUpdatePass {
  Vector vector;
  Row* rows;
  const StepState* state;

  HOST_DEVICE viscosity::Norms operator()(Index i) const {
    const auto alpha = static_cast<float>(state->viscous.alpha);
    const auto beta = static_cast<float>(state->viscous.beta);
    Row& row = rows[i];
    float* u = vector[i];
    for (int c = 0; c < 3; ++c) {
      row.direction[c] = u[c] + beta * row.direction[c];
      row.along[c] = row.product[c] + beta * row.along[c];
      row.increment[c] += alpha * row.direction[c];
      row.residual[c] -= alpha * row.along[c];
      u[c] = row.residual[c] / row.diagonal;
    }
    return viscosity::norms_of(row);
  }
};

namespace viscosity {

/// Whether the iteration is over, of a residual whose square is given.
HOST_DEVICE inline void judge(ViscousState& v, double squared, double tolerance, int most_iterations) {
  v.residual = v.scale > 0 ? std::sqrt(squared) / v.scale : 0;
  v.converged = v.residual <= tolerance ? 1 : 0;
  v.running = v.converged == 0 && v.iterations < most_iterations && std::isfinite(v.residual) ? 1 : 0;
}

}  // namespace viscosity

/// Begins the solve for the velocities of the fluid near sediment at the end of the step of state->step.dt. The
/// residual it will stop at is scene.viscous_tolerance of the momentum that gravity and the present accelerations give
/// in one step (without gravity: of the first residual).
template <int Dim, class Device, class Coupling>
void begin_viscous_solve(Device& on, Particles<Device>& p, const Scene<Dim>& scene, ViscousSystem<Device>& system,
                         StepState* state, const Coupling& coupling) {
  using Row = typename ViscousSystem<Device>::Row;
  using Kept = typename Device::PairCoefficient;
  const ClusterList list = p.list();
  const ClusterRange range = p.near_sediment();
  if (range.count == 0) return;
  constexpr bool stored = Device::stores_coefficients || Coupling::needs_stored;
  if constexpr (stored) {
    system.coefficient.resize(p.list_entries.size() * cluster_size);
    system.vectors.resize(std::size_t{p.count} + 1);
  }
  system.row.resize(p.count);
  Record* records = p.record.data();
  Row* rows = system.row.data();
  Sediment* sediment = p.sediment.data();
  const auto vector = iteration_vector<stored>(p, system);
  if constexpr (stored) {  // zero for walls and water far from sediment
    on.for_each(p.count + 1, [=] HOST_DEVICE(Index i) { vector.from[i] = {}; });
  }
  // What viscosity did in the last step is the best guess of what it does in this one.
  for_each_member(on, list, range, [=] HOST_DEVICE(Index i) {
    const auto dt = static_cast<float>(state->step.dt);
    for (int c = 0; c < 3; ++c) records[i].velocity[c] += dt * sediment[i].viscous_acceleration[c];
  });
  const double tolerance = scene.viscous_tolerance;
  const int most_iterations = scene.viscous_iterations;
  on.template sweep_then<Dim>(
      list, range, records, scene.lattice.quantum,
      ViscousCoefficientSweep<Dim, stored, Kept, Row, Coupling>{
          records, p.mass.data(), p.rates.data(), sediment, vector, system.coefficient.data(), rows, coupling, state},
      viscosity::Norms{}, viscosity::AddNorms{}, [=] HOST_DEVICE(const viscosity::Norms& norms) {
        ViscousState& v = state->viscous;
        v = {};
        v.preconditioned = norms.preconditioned;
        v.scale = state->step.dt * std::sqrt(norms.momentum);
        if (v.scale == 0) v.scale = std::sqrt(norms.squared);
        viscosity::judge(v, norms.squared, tolerance, most_iterations);
      });
  for_each_member(on, list, range, [=] HOST_DEVICE(Index i) {
    for (int c = 0; c < 3; ++c) vector[i][c] = rows[i].residual[c] / rows[i].diagonal;
  });
}

/// At most so many iterations of the solve begun; on the host it stops when the solve is over.
template <int Dim, class Device, class Coupling>
void iterate_viscous_solve(Device& on, Particles<Device>& p, const Scene<Dim>& scene, ViscousSystem<Device>& system,
                           StepState* state, int iterations, const Coupling& coupling) {
  using Row = typename ViscousSystem<Device>::Row;
  using Kept = typename Device::PairCoefficient;
  const ClusterList list = p.list();
  const ClusterRange range = p.near_sediment();
  if (range.count == 0) return;
  constexpr bool stored = Device::stores_coefficients || Coupling::needs_stored;
  Record* records = p.record.data();
  Row* rows = system.row.data();
  const double tolerance = scene.viscous_tolerance;
  const int most_iterations = scene.viscous_iterations;
  const auto vector = iteration_vector<stored>(p, system);
  const int* const outer = on.only_if(&state->viscous.running);
  for (int n = 0; n < iterations; ++n) {
    if constexpr (Device::is_host) {
      if (state->viscous.running == 0) break;
    }
    on.template sweep_then<Dim>(
        list, range, vector.from, scene.lattice.quantum,
        ViscousProductSweep<Dim, stored, Kept, Row, Coupling>{records, vector, system.coefficient.data(), rows,
                                                              coupling, state},
        0.0, [] HOST_DEVICE(double a, double b) { return a + b; },
        [=] HOST_DEVICE(double product) {
          ViscousState& v = state->viscous;
          v.beta = v.iterations == 0 ? 0 : v.preconditioned / v.before;
          v.alpha = v.preconditioned / (v.iterations == 0 ? product : product - v.beta * v.preconditioned / v.alpha);
        });
    reduce_members_then(on, list, range, viscosity::Norms{},
                        ViscousUpdatePass<Row, IterationVector<stored>>{vector, rows, state}, viscosity::AddNorms{},
                        [=] HOST_DEVICE(const viscosity::Norms& norms) {
                          ViscousState& v = state->viscous;
                          v.before = v.preconditioned;
                          v.preconditioned = norms.preconditioned;
                          ++v.iterations;
                          viscosity::judge(v, norms.squared, tolerance, most_iterations);
                        });
  }
  on.only_if(outer);
}

/// Replaces the velocities by the solution, or takes the guess back where there is none; then, and where the iteration
/// needs longer, no particle moves.
template <class Device>
void end_viscous_solve(Device& on, Particles<Device>& p, ViscousSystem<Device>& system, StepState* state) {
  const ClusterRange range = p.near_sediment();
  if (range.count == 0) return;
  const auto* rows = system.row.data();
  Record* records = p.record.data();
  Sediment* sediment = p.sediment.data();
  for_each_member(on, p.list(), range, [=] HOST_DEVICE(Index i) {
    const ViscousState& v = state->viscous;
    if (state->go == 0 || v.running != 0) return;
    const auto dt = static_cast<float>(state->step.dt);
    for (int c = 0; c < 3; ++c) {
      if (v.converged != 0) {
        records[i].velocity[c] += rows[i].increment[c];
        sediment[i].viscous_acceleration[c] += rows[i].increment[c] / dt;
      } else {
        records[i].velocity[c] -= dt * sediment[i].viscous_acceleration[c];
      }
    }
  });
  on.for_each(1, [=] HOST_DEVICE(Index) {
    state->moves = state->go != 0 && state->viscous.running == 0 && state->viscous.converged != 0 ? 1 : 0;
  });
}

}  // namespace thalweg
