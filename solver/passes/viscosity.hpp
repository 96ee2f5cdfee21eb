#pragma once

#include <cmath>
#include <type_traits>

#include "solver/particles.hpp"
#include "solver/physics/pair_terms.hpp"

// Implicit viscosity of the sediment and of the layer between water and sediment: solves
//   m_a u_a + dt sum_b k_ab (u_a - u_b) = m_a u*_a
// for the velocities at the end of the step, walls standing still. k_ab = k_ba >= 0 makes the system symmetric and
// positive definite; it is solved by conjugate gradients with Jacobi preconditioning on the clusters with sediment in
// reach. An explicit treatment would need steps 50 to 400 times smaller, a cap on the viscosity makes a bed creep
// (docs/theory.md).
namespace thalweg {

/// Arrays of the solve, kept between steps.
template <class Device>
struct ViscousSystem {
  template <class T>
  using Buffer = typename Device::template Buffer<T>;
  struct Row {
    float residual[3];  // [kg m/s]
    float diagonal;     // [kg]
    float product[3];   // A p of the last iteration
    float unused;
    float increment[3];  // of the velocity [m/s]
    float unused2;
  };
  Buffer<float> coefficient;  // dt k_ab [kg], one a pair, in the order of the lists
  Buffer<Row> row;
};

/// How the viscous part of a step went (solve_viscosity; passes/viscous_step.hpp for the last two).
struct ViscousResult {
  int iterations = 0;
  double residual = 0;  // over the momentum one step of gravity gives [-]
  bool converged = true;
  int retries = 0;          // solves that had to be made again
  std::int64_t capped = 0;  // particles whose viscosity was cut
};

/// What couples the velocities of two particles in a single-layer bed: the sediment's viscosity, and the layer between
/// water and sediment.
template <int Dim>
struct ViscousCoupling {
  static constexpr unsigned quads = quad_place | quad_motion | quad_matter;
  static constexpr bool needs_stored = false;
  Scene<Dim> scene;

  /// k_ab [kg/s]; u = u_a - u_b.
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
/// first guess dt v of what viscosity adds: -m_a dt v_a - dt sum k_ab (u_a - u_b). If `stored`, the coefficients dt
/// k_ab as well.
template <int Dim, bool stored, class Row, class Coupling>
struct ViscousCoefficientSweep {
  static constexpr unsigned quads = Coupling::quads;
  template <class L>
  struct Sum {
    L coefficients;
    Vec<Dim, L> exchange;
  };

  const Record* records;
  const float* mass;
  const Sediment* sediment;
  float* coefficient;
  Row* rows;
  Coupling coupling;
  float dt;

  template <class LaneT, class Sep, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const Sep& s, std::size_t entry, Sum<L>& sum) const {
    const Vec<Dim, L> u = a.velocity - b.velocity;
    const L closeness = coupling.scene.kernel.closeness(lane_sqrt(s.r2));
    const L k = L(dt) * coupling.coefficient(a, b, u, closeness);
    if constexpr (stored) lane_store(coefficient + entry, k);
    sum.coefficients += k;
    for (int c = 0; c < Dim; ++c) sum.exchange[c] += k * u[c];
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    Row& row = rows[i];
    row.diagonal = mass[i] + sum.coefficients;
    for (int c = 0; c < 3; ++c) row.increment[c] = row.residual[c] = row.product[c] = 0;
    if (is_resting(records[i])) return;
    for (int c = 0; c < Dim; ++c) {
      const int k = axis<Dim>(c);
      row.residual[k] = -mass[i] * dt * sediment[i].viscous_acceleration[k] - sum.exchange[c];
    }
  }
};

/// Pair sweep: A p, p in the records' work quad; the coefficients dt k_ab as stored, or computed again from the
/// velocities u, which stay in the records until the iteration is over.
template <int Dim, bool stored, class Row, class Coupling>
struct ViscousProductSweep {
  static constexpr unsigned quads = stored ? unsigned{quad_work} : quad_work | Coupling::quads;
  template <class L>
  struct Sum {
    Vec<Dim, L> exchange;
  };

  const Record* records;
  const float* mass;
  const float* coefficient;
  Row* rows;
  Coupling coupling;
  float dt;

  template <class LaneT, class Sep, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const Sep& s, std::size_t entry, Sum<L>& sum) const {
    L k;
    if constexpr (stored) {
      lane_load(coefficient + entry, k);
    } else {
      const L closeness = coupling.scene.kernel.closeness(lane_sqrt(s.r2));
      k = L(dt) * coupling.coefficient(a, b, a.velocity - b.velocity, closeness);
    }
    for (int c = 0; c < Dim; ++c) sum.exchange[c] += k * (a.work[c] - b.work[c]);
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    if (is_resting(records[i])) return;  // a wall: its velocity is no unknown
    for (int c = 0; c < Dim; ++c) {
      rows[i].product[axis<Dim>(c)] = mass[i] * records[i].work[axis<Dim>(c)] + sum.exchange[c];
    }
  }
};

namespace viscosity {

HOST_DEVICE inline double dot3(const float* a, const float* b) {
  return double(a[0]) * double(b[0]) + double(a[1]) * double(b[1]) + double(a[2]) * double(b[2]);
}

/// The two sums the iteration needs of the residuals.
struct Norms {
  double preconditioned = 0;  // r . r / diagonal
  double squared = 0;         // r . r
};

/// Sum of of(i) over those particles, `of` returning double or Norms; may change what it visits.
template <class T, class Device, class Of>
T sum_over_members(Device& on, const ClusterList& list, ClusterRange range, const Of& of) {
  const auto add = [] HOST_DEVICE(T a, const T& b) {
    if constexpr (std::is_same_v<T, Norms>) {
      return Norms{a.preconditioned + b.preconditioned, a.squared + b.squared};
    } else {
      return a + b;
    }
  };
  return on.reduce(
      range.count, T{},
      [=] HOST_DEVICE(Index n) {
        const Index c = range[n];
        T sum{};
        for (Index i = list.first(c); i < list.last(c); ++i) sum = add(sum, of(i));
        return sum;
      },
      add);
}

template <class Row>
HOST_DEVICE Norms norms_of(const Row& row) {
  const double squared = dot3(row.residual, row.residual);
  return {squared / double(row.diagonal), squared};
}

/// Root of the summed squares of the momentum that gravity and the present accelerations give in a step [kg m/s].
template <int Dim, class Device>
double momentum_of_a_step(Device& on, const Particles<Device>& p, const Scene<Dim>& scene, float dt) {
  double g2 = 0;
  for (int k = 0; k < Dim; ++k) g2 += double(scene.gravity[k]) * double(scene.gravity[k]);
  const float* mass = p.mass.data();
  const Rates* rates = p.rates.data();
  const Sediment* sediment = p.sediment.data();
  const double squares = sum_over_members<double>(on, p.list(), p.near_sediment(), [=] HOST_DEVICE(Index i) {
    const double m = mass[i];
    const float* viscous = sediment[i].viscous_acceleration;
    return m * m * (g2 + dot3(rates[i].acceleration, rates[i].acceleration) + dot3(viscous, viscous));
  });
  return double(dt) * std::sqrt(squares);
}

}  // namespace viscosity

/// Replaces the velocities of the fluid near sediment by the solution, or leaves them where the iteration did not
/// converge within scene.viscous_iterations. The residual it stops at is
/// scene.viscous_tolerance of the momentum that gravity and the present accelerations give in one step (without
/// gravity: of the first residual).
template <int Dim, class Device, class Coupling>
ViscousResult solve_viscosity(Device& on, Particles<Device>& p, const Scene<Dim>& scene, ViscousSystem<Device>& system,
                              float dt, const Coupling& coupling) {
  using viscosity::dot3;
  using Row = typename ViscousSystem<Device>::Row;
  const ClusterList list = p.list();
  const ClusterRange range = p.near_sediment();
  if (range.count == 0) return {};
  constexpr bool stored = Device::stores_coefficients || Coupling::needs_stored;
  if constexpr (stored) system.coefficient.resize(p.list_entries.size() * cluster_size);
  system.row.resize(p.count);
  Record* records = p.record.data();
  Row* rows = system.row.data();
  const float* mass = p.mass.data();
  Sediment* sediment = p.sediment.data();
  using viscosity::Norms;
  const auto total = [&](const auto& of) { return viscosity::sum_over_members<double>(on, list, range, of); };
  const auto norms = [&](const auto& of) { return viscosity::sum_over_members<Norms>(on, list, range, of); };
  const auto each = [&](const auto& body) { for_each_member(on, list, range, body); };

  // What viscosity did in the last step is the best guess of what it does in this one.
  each([=] HOST_DEVICE(Index i) {
    for (int c = 0; c < 3; ++c) records[i].velocity[c] += dt * sediment[i].viscous_acceleration[c];
  });
  on.template sweep<Dim>(list, range, records, scene.lattice.quantum,
                         ViscousCoefficientSweep<Dim, stored, Row, Coupling>{
                             records, mass, sediment, system.coefficient.data(), rows, coupling, dt});
  Norms now = norms([=] HOST_DEVICE(Index i) {
    for (int c = 0; c < 3; ++c) records[i].work[c] = rows[i].residual[c] / rows[i].diagonal;
    return viscosity::norms_of(rows[i]);
  });
  double scale = viscosity::momentum_of_a_step(on, p, scene, dt);
  if (scale == 0) scale = std::sqrt(now.squared);

  ViscousResult result;
  while (true) {
    result.residual = scale > 0 ? std::sqrt(now.squared) / scale : 0;
    result.converged = result.residual <= scene.viscous_tolerance;
    if (result.converged || result.iterations == scene.viscous_iterations || !std::isfinite(result.residual)) break;
    on.template sweep<Dim>(
        list, range, records, scene.lattice.quantum,
        ViscousProductSweep<Dim, stored, Row, Coupling>{records, mass, system.coefficient.data(), rows, coupling, dt});
    const double pAp = total([=] HOST_DEVICE(Index i) { return dot3(records[i].work, rows[i].product); });
    const auto alpha = static_cast<float>(now.preconditioned / pAp);
    const Norms next = norms([=] HOST_DEVICE(Index i) {
      for (int c = 0; c < 3; ++c) {
        rows[i].increment[c] += alpha * records[i].work[c];
        rows[i].residual[c] -= alpha * rows[i].product[c];
      }
      return viscosity::norms_of(rows[i]);
    });
    const auto beta = static_cast<float>(next.preconditioned / now.preconditioned);
    now = next;
    each([=] HOST_DEVICE(Index i) {
      for (int c = 0; c < 3; ++c)
        records[i].work[c] = rows[i].residual[c] / rows[i].diagonal + beta * records[i].work[c];
    });
    ++result.iterations;
  }
  const bool converged = result.converged;
  each([=] HOST_DEVICE(Index i) {
    for (int c = 0; c < 3; ++c) {
      if (converged) {
        records[i].velocity[c] += rows[i].increment[c];
        sediment[i].viscous_acceleration[c] += rows[i].increment[c] / dt;
      } else {
        records[i].velocity[c] -= dt * sediment[i].viscous_acceleration[c];
      }
    }
  });
  return result;
}

template <int Dim, class Device>
ViscousResult solve_viscosity(Device& on, Particles<Device>& p, const Scene<Dim>& scene, ViscousSystem<Device>& system,
                              float dt) {
  return solve_viscosity(on, p, scene, system, dt, ViscousCoupling<Dim>{scene});
}

}  // namespace thalweg
