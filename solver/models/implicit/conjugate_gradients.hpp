#pragma once

#include <cmath>

#include "physics/no_slip.hpp"
#include "solver/models/bed/arrays.hpp"
#include "solver/models/implicit/viscous_system.hpp"
#include "solver/passes/sweep.hpp"

// Implicit viscosity of the sediment and of the layer between water and sediment: solves
//   m_a u_a + dt sum_b k_ab (u_a - u_b) = m_a u*_a
// for the velocities at the end of the step, walls standing still (and dragging as physics/no_slip.hpp says). k_ab =
// k_ba >= 0 makes the system symmetric and positive definite; it is solved by conjugate gradients with Jacobi
// preconditioning on the clusters with sediment in reach. An explicit treatment would need steps 50 to 400 times
// smaller, a cap on the viscosity makes a bed creep (docs/theory.md).
//
// Coefficients that are stored between iterations take half a float (ShortFloat). The unknown is the change since the
// last step, from a residual of full precision, and with each k_ab off by 2^-9 at most, all of
// them positive and k_ab = k_ba to the last bit, the quadratic form of the system is off by no more than that share.
//
// The gradients are those of Chronopoulos & Gear (1989): an iteration is one sweep and one pass, each with its sum, and
// the numbers they exchange stay on the device (ViscousState).
namespace thalweg {

/// Pair sweep: the diagonal and the residual of the first guess, -m_a dt v_a - dt sum k_ab (u_a - u_b). The records
/// hold the guess u = u* + dt v: the explicit velocity and the viscous acceleration of the last step. If `stored`, the
/// sweep stores the coefficients k_ab as well.
template <int Dim, bool stored, class Kept, class Row, class Coupling>
struct ViscousCoefficientSweep {
  using neighbours = typename Coupling::neighbours;
  using reads =
      Reads<field::place, field::flow, field::matter, field::mass, field::loaded_mass, field::rates, field::sediment>;
  using writes = VectorField<stored>;
  static constexpr unsigned kernel = Coupling::kernel;
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

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t entry,
                        Sum<L>& sum) const {
    const Vec<Dim, L> u = a.velocity - b.velocity;
    const L k = coupling.coefficient(a, b, u, g);
    if constexpr (stored) lane_store(coefficient + entry, k);
    sum.coefficients += k;
    for (int c = 0; c < Dim; ++c) sum.exchange[c] += k * u[c];
    sum.walls.add(lane_select(is_wall(b), k, L(0.0F)), g, u);
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
  using neighbours = std::conditional_t<stored, Neighbours<field::viscous_vectors>,
                                        typename Coupling::neighbours::template With<field::viscous_vector>>;
  using reads = std::conditional_t<stored, Reads<field::matter, field::viscous_vectors>,
                                   Reads<field::matter, field::viscous_vector>>;
  using writes = Writes<>;
  static constexpr unsigned kernel = stored ? unsigned{no_kernel} : Coupling::kernel;
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

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t entry,
                        Sum<L>& sum) const {
    L k;
    if constexpr (stored) {
      lane_load(coefficient + entry, k);
    } else {
      k = coupling.coefficient(a, b, a.velocity - b.velocity, g);
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
  using reads = typename Vector::InField;
  using writes = typename Vector::InField;

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

/// Resizes a buffer whose contents nobody needs.
template <class Buffer>
void resize_anew(Buffer& buffer, std::size_t n) {
  if constexpr (requires { buffer.resize_anew(n); }) {
    buffer.resize_anew(n);
  } else {
    buffer.resize(n);
  }
}

/// True if the pair coefficients are stored on a device with a coupling.
template <class Coupling, class Device>
constexpr bool stores_coefficients(const Device& on) {
  return Coupling::needs_stored || on.stores_coefficients();
}
/// True if a device can compute them again; a host never does.
template <class Device, class Coupling>
inline constexpr bool may_compute_again = !Device::is_host && !Coupling::needs_stored;

/// Begins the solve for the velocities of the fluid near sediment at the end of the step of state->step.dt. The
/// residual it will stop at is scene.viscous_tolerance of the momentum that gravity and the present accelerations give
/// in one step (without gravity: of the first residual).
template <bool stored, int Dim, class Device, class Coupling>
void begin_viscous_solve_as(Device& on, Particles<Device>& p, const Scene<Dim>& scene, ViscousSystem<Device>& system,
                            StepState* state, const Coupling& coupling) {
  using Row = typename ViscousSystem<Device>::Row;
  using Kept = typename Device::PairCoefficient;
  const ClusterList list = p.list();
  const ClusterRange range = p.near_sediment();
  if (range.count == 0 && on.shared == nullptr) return;  // all ranks take part in the sums
  if constexpr (stored) {
    resize_anew(system.coefficient, p.list_entries.size() * cluster_size);
    system.vectors.resize(std::size_t{p.with_copies()} + 1);
  }
  system.row.resize(p.count);
  Record* records = p.record.data();
  Row* rows = system.row.data();
  Sediment* sediment = p.sediment.data();
  const auto vector = iteration_vector<stored>(p, system);
  if constexpr (stored) {  // zero for walls and water far from sediment
    on.for_each(p.with_copies() + 1,
                declare<Reads<>, VectorField<stored>>([=] HOST_DEVICE(Index i) { vector.from[i] = {}; }));
  }
  // The viscous acceleration of the last step is the best guess for this one.
  for_each_member(on, list, range,
                  declare<Reads<field::flow, field::sediment>, Writes<field::flow>>([=] HOST_DEVICE(Index i) {
                    const auto dt = static_cast<float>(state->step.dt);
                    for (int c = 0; c < 3; ++c) records[i].velocity[c] += dt * sediment[i].viscous_acceleration[c];
                  }));
  const double tolerance = scene.viscous_tolerance;
  const int most_iterations = scene.viscous_iterations;
  on.template sweep_then<Dim>(
      list, range, records, scene.metric(),
      ViscousCoefficientSweep<Dim, stored, Kept, Row, Coupling>{records, p.inertia(), p.rates.data(), sediment, vector,
                                                                system.coefficient.data(), rows, coupling, state},
      viscosity::Norms{}, viscosity::AddNorms{}, [=] HOST_DEVICE(const viscosity::Norms& norms) {
        ViscousState& v = state->viscous;
        v = {};
        v.preconditioned = norms.preconditioned;
        v.scale = state->step.dt * std::sqrt(norms.momentum);
        if (v.scale == 0) v.scale = std::sqrt(norms.squared);
        viscosity::judge(v, norms.squared, tolerance, most_iterations);
      });
  for_each_member(on, list, range, declare<Reads<>, VectorField<stored>>([=] HOST_DEVICE(Index i) {
                    for (int c = 0; c < 3; ++c) vector[i][c] = rows[i].residual[c] / rows[i].diagonal;
                  }));
}

template <int Dim, class Device, class Coupling>
void begin_viscous_solve(Device& on, Particles<Device>& p, const Scene<Dim>& scene, ViscousSystem<Device>& system,
                         StepState* state, const Coupling& coupling) {
  if constexpr (may_compute_again<Device, Coupling>) {
    if (!stores_coefficients<Coupling>(on)) {
      return begin_viscous_solve_as<false>(on, p, scene, system, state, coupling);
    }
  }
  begin_viscous_solve_as<true>(on, p, scene, system, state, coupling);
}

/// True where the host follows every iteration: it is the device, or several ranks add up their sums.
template <class Device>
bool waits_for_device(const Device& on) {
  return Device::is_host || on.shared != nullptr;
}

/// At most so many iterations of the solve begun; a host that follows them stops when the solve is over.
template <bool stored, int Dim, class Device, class Coupling>
void iterate_viscous_solve_as(Device& on, Particles<Device>& p, const Scene<Dim>& scene, ViscousSystem<Device>& system,
                              StepState* state, int iterations, const Coupling& coupling) {
  using Row = typename ViscousSystem<Device>::Row;
  using Kept = typename Device::PairCoefficient;
  const ClusterList list = p.list();
  const ClusterRange range = p.near_sediment();
  if (range.count == 0 && on.shared == nullptr) return;  // all ranks take part in the sums
  Record* records = p.record.data();
  Row* rows = system.row.data();
  const double tolerance = scene.viscous_tolerance;
  const int most_iterations = scene.viscous_iterations;
  const auto vector = iteration_vector<stored>(p, system);
  const int* const outer = on.skip_unless(&state->viscous.running);
  for (int n = 0; n < iterations; ++n) {
    if (waits_for_device(on) && on.read(&state->viscous.running) == 0) break;
    on.template sweep_then<Dim>(
        list, range, vector.from, scene.metric(),
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
  on.skip_unless(outer);
}
template <int Dim, class Device, class Coupling>
void iterate_viscous_solve(Device& on, Particles<Device>& p, const Scene<Dim>& scene, ViscousSystem<Device>& system,
                           StepState* state, int iterations, const Coupling& coupling) {
  if constexpr (may_compute_again<Device, Coupling>) {
    if (!stores_coefficients<Coupling>(on)) {
      return iterate_viscous_solve_as<false>(on, p, scene, system, state, iterations, coupling);
    }
  }
  iterate_viscous_solve_as<true>(on, p, scene, system, state, iterations, coupling);
}

/// Replaces the velocities by the solution, or takes the guess back where there is none; then, and where the iteration
/// needs longer, no particle moves.
template <class Device>
void end_viscous_solve(Device& on, Particles<Device>& p, ViscousSystem<Device>& system, StepState* state) {
  const ClusterRange range = p.near_sediment();
  if (range.count == 0 && on.shared == nullptr) return;  // all ranks take part in the sums
  const auto* rows = system.row.data();
  Record* records = p.record.data();
  Sediment* sediment = p.sediment.data();
  for_each_member(
      on, p.list(), range,
      declare<Reads<field::flow, field::sediment>, Writes<field::flow, field::sediment>>([=] HOST_DEVICE(Index i) {
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
      }));
  on.for_each(1, declare<Reads<>, Writes<>>([=] HOST_DEVICE(Index) {
                state->moves = state->go != 0 && state->viscous.running == 0 && state->viscous.converged != 0 ? 1 : 0;
              }));
}

}  // namespace thalweg
