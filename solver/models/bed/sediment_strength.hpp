#pragma once

#include <cmath>

#include "physics/sediment/suspension_viscosity.hpp"
#include "solver/models/bed/laplace_pressure.hpp"
#include "solver/models/bed/sediment_law.hpp"

// The sediment's strength: effective pressure = submerged weight of the sediment above (or what the scene has chosen),
// yield stress, apparent viscosity. The dynamic pressure of the water does not enter: it would turn wave impact into
// strength (docs/theory.md). Weights follow the places of the particles and are taken anew when the neighbour lists
// are; until then no particle has moved by more than half the lists' skin.
namespace thalweg {

/// Volume of sediment above each node of a lattice of columns one spacing apart. Volumes are summed as integers, so
/// that the result does not depend on the order of the particles.
template <class Device>
struct ColumnWeight {
  typename Device::template Buffer<std::int64_t> deposited;  // per node, in volume quanta
  typename Device::template Buffer<float> height_above;      // per node [m]
  typename Device::template Buffer<float> surface;           // per column: height of the bed's surface over node 0 [m]
  typename Device::template Buffer<float> slope;             // per column: tangent of the surface's steepest slope
  typename Device::template Buffer<std::uint8_t> wetted;     // per column: any fluid here
};

/// A column without a bed to speak of: less than one spacing of sediment.
inline constexpr float no_surface = -1;

template <int Dim>
struct ColumnLattice {
  Vec<Dim, double> from{};     // [m]
  double inverse_spacing = 0;  // [1/m]
  Vec<Dim, int> nodes{};
  bool periodic[Dim] = {};
  double quanta_per_volume = 0;

  explicit ColumnLattice(const Scene<Dim>& scene) {
    inverse_spacing = 1 / scene.spacing;
    for (int k = 0; k < Dim; ++k) {
      // Nodes where the particles started, so that a column at a wall is covered whole or not at all.
      const double to_node = scene.lattice_node[k] - scene.domain_from[k];
      from[k] = scene.lattice_node[k] - std::ceil(to_node * inverse_spacing) * scene.spacing;
      nodes[k] = static_cast<int>(std::ceil((scene.domain_to[k] - from[k]) * inverse_spacing)) + 2;
      periodic[k] = scene.lattice.periodic[k];
      if (periodic[k])
        nodes[k] = std::max(1, static_cast<int>(std::lround((scene.domain_to[k] - from[k]) * inverse_spacing)));
    }
    quanta_per_volume = 4294967296.0 * std::pow(inverse_spacing, Dim);
  }

  [[nodiscard]] HOST_DEVICE int columns() const {
    int n = 1;
    for (int k = 0; k + 1 < Dim; ++k) n *= nodes[k];
    return n;
  }
  [[nodiscard]] HOST_DEVICE int levels() const { return nodes[Dim - 1]; }

  /// Node below a coordinate, and how far towards the next one it lies [0, 1).
  HOST_DEVICE int below(int k, double x, float& fraction) const {
    const double at = (x - from[k]) * inverse_spacing;
    const double node = floor(at);
    fraction = static_cast<float>(at - node);
    return static_cast<int>(node);
  }
  /// Index of a column direction's node inside the lattice: around a period, or -1 beyond an end.
  HOST_DEVICE int inside(int k, int node) const {
    if (periodic[k]) return (node % nodes[k] + nodes[k]) % nodes[k];
    return node >= 0 && node < nodes[k] ? node : -1;
  }
};

/// Particle pass: shares each sediment particle's volume among the nodes around it (linearly), marks wetted columns.
template <int Dim, class AtomicAdd>
struct DepositPass {
  const Record* records;
  const Position* positions;
  ColumnLattice<Dim> columns;
  std::int64_t* deposited;
  std::uint8_t* wetted;
  AtomicAdd atomic_add_to;

  HOST_DEVICE void operator()(Index i) const {
    const Record& r = records[i];
    if (r.volume == 0) return;
    float share[Dim];
    int node[Dim];
    for (int k = 0; k < Dim; ++k) node[k] = columns.below(k, positions[i].x[axis<Dim>(k)], share[k]);
    const int levels = columns.levels();
    for (int corner = 0; corner < (1 << Dim); ++corner) {
      float weight = 1;
      int column = 0;
      bool in = true;
      for (int k = Dim - 2; k >= 0; --k) {
        const int step = (corner >> k) & 1;
        weight *= step != 0 ? share[k] : 1 - share[k];
        const int n = columns.inside(k, node[k] + step);
        in = in && n >= 0;
        column = column * columns.nodes[k] + n;
      }
      if (!in) continue;
      const int up = (corner >> (Dim - 1)) & 1;
      const int level = node[Dim - 1] + up;
      if (weight >= 0.5F) wetted[column] = 1;
      if (r.phase != phase_sediment || level < 0 || level >= levels) continue;
      weight *= up != 0 ? share[Dim - 1] : 1 - share[Dim - 1];
      atomic_add_to(deposited + static_cast<std::int64_t>(column) * levels + level,
                    static_cast<std::int64_t>(static_cast<double>(weight * r.volume) * columns.quanta_per_volume));
    }
  }
};

/// Pass over the columns: height of sediment above each node, its own half included, and the bed's surface: where one
/// spacing of sediment lies above, so that flying grains are not taken for it. Sediment that hovers over a gap, a node
/// with less than a tenth of a full one, is no load on what lies below.
template <int Dim>
struct HeightAbovePass {
  ColumnLattice<Dim> columns;
  const std::int64_t* deposited;
  float* height_above;
  float* surface;
  float height_per_quantum;  // [m]
  float spacing;             // [m]

  HOST_DEVICE void operator()(Index column) const {
    const int levels = columns.levels();
    const std::int64_t base = static_cast<std::int64_t>(column) * levels;
    std::int64_t above = 0;
    float next = 0;
    surface[column] = no_surface;
    for (int level = levels - 1; level >= 0; --level) {
      const std::int64_t own = deposited[base + level];
      if (static_cast<float>(own) * height_per_quantum < 0.1F * spacing) above = 0, next = 0;
      const float height = static_cast<float>(2 * above + own) * (0.5F * height_per_quantum);
      if (next < spacing && height >= spacing) {
        surface[column] = (static_cast<float>(level) + (height - spacing) / (height - next)) * spacing;
      }
      height_above[base + level] = next = height;
      above += own;
    }
  }
};

/// Pass over the columns: tangent of the slope of the plane that fits the bed's surface best within a support to either
/// side, weighted towards the middle; 0 where too few columns have a bed.
template <int Dim>
struct ColumnSlopePass {
  ColumnLattice<Dim> columns;
  const float* surface;
  float* slope;
  float spacing;  // [m]
  int reach;      // [spacings]

  HOST_DEVICE void operator()(Index column) const {
    const int own[2] = {static_cast<int>(column) % columns.nodes[0], static_cast<int>(column) / columns.nodes[0]};
    const int rows = Dim == 3 ? reach : 0;
    float w = 0, wx = 0, wy = 0, wz = 0, wxx = 0, wxy = 0, wyy = 0, wxz = 0, wyz = 0;
    for (int dy = -rows; dy <= rows; ++dy) {
      for (int dx = -reach; dx <= reach; ++dx) {
        int other = columns.inside(0, own[0] + dx);
        if constexpr (Dim == 3) {
          const int row = columns.inside(1, own[1] + dy);
          other = other < 0 || row < 0 ? -1 : row * columns.nodes[0] + other;
        }
        if (other < 0 || surface[other] == no_surface) continue;
        const float x = static_cast<float>(dx) * spacing;
        const float y = static_cast<float>(dy) * spacing;
        const float z = surface[other];
        const float one = static_cast<float>(reach + 1);
        const float weight = (1 - fabsf(static_cast<float>(dx)) / one) * (1 - fabsf(static_cast<float>(dy)) / one);
        w += weight, wx += weight * x, wy += weight * y, wz += weight * z;
        wxx += weight * x * x, wxy += weight * x * y, wyy += weight * y * y;
        wxz += weight * x * z, wyz += weight * y * z;
      }
    }
    slope[column] = 0;
    if (w == 0) return;
    const float cxx = wxx - wx * wx / w, cxz = wxz - wx * wz / w;
    const float least = 0.5F * w * spacing * spacing;  // the spread of three columns in a row
    if constexpr (Dim == 2) {
      if (cxx > least) slope[column] = fabsf(cxz / cxx);
    } else {
      const float cyy = wyy - wy * wy / w, cxy = wxy - wx * wy / w, cyz = wyz - wy * wz / w;
      const float det = cxx * cyy - cxy * cxy;
      if (det < least * least) return;
      const float sx = (cxz * cyy - cyz * cxy) / det;
      const float sy = (cyz * cxx - cxz * cxy) / det;
      slope[column] = sqrtf(sx * sx + sy * sy);
    }
  }
};

/// Particle pass: slope of the bed and, where the columns say it, effective pressure gamma' z cos^2(beta): the pressure
/// normal to a surface of slope beta, so that an infinite slope stands up to tan(beta) = K. The height z is averaged
/// over the wetted columns within a support to either side, so that single particles at the surface do not make steps
/// of strength; beta is counted up to the friction angle, what is steeper slides.
template <int Dim>
struct EffectivePressurePass {
  const Record* records;
  const Position* positions;
  Sediment* sediment;
  ColumnLattice<Dim> columns;
  const float* height_above;
  const float* slope;
  const std::uint8_t* wetted;
  SedimentScene law;
  float reach;     // of the average, in spacings
  bool by_column;  // the effective pressure is the columns'

  HOST_DEVICE void operator()(Index i) const {
    if (records[i].phase != phase_sediment) return;
    Sediment& s = sediment[i];
    s.bed_slope = slope_at(i);
    const float t = s.bed_slope < law.friction_tangent ? s.bed_slope : law.friction_tangent;
    if (by_column) {
      s.effective_pressure = effective_pressure_of_column(law.submerged_weight, mean_height_above(i), 1 / (1 + t * t));
    }
  }

  HOST_DEVICE float slope_at(Index i) const {
    int column = 0;
    for (int k = Dim - 2; k >= 0; --k) {
      float share;
      const int node = columns.below(k, positions[i].x[axis<Dim>(k)], share);
      const int nearest = columns.inside(k, share < 0.5F ? node : node + 1);
      if (nearest < 0) return 0;
      column = column * columns.nodes[k] + nearest;
    }
    return slope[column];
  }

  HOST_DEVICE float mean_height_above(Index i) const {
    float share[Dim];
    int node[Dim];
    for (int k = 0; k < Dim; ++k) node[k] = columns.below(k, positions[i].x[axis<Dim>(k)], share[k]);
    const int level = node[Dim - 1];
    if (level < 0 || level + 1 >= columns.levels()) return 0;
    const int around = static_cast<int>(reach);
    float sum = 0;
    float weights = 0;
    const int rows = Dim == 3 ? around : 0;
    for (int dy = -rows; dy <= rows + (Dim == 3 ? 1 : 0); ++dy) {
      for (int dx = -around; dx <= around + 1; ++dx) {
        float weight = hat(static_cast<float>(dx) - share[0]);
        int column = columns.inside(0, node[0] + dx);
        if constexpr (Dim == 3) {
          weight *= hat(static_cast<float>(dy) - share[1]);
          const int row = columns.inside(1, node[1] + dy);
          column = column < 0 || row < 0 ? -1 : row * columns.nodes[0] + column;
        }
        if (column < 0 || wetted[column] == 0) continue;
        const float* above = height_above + static_cast<std::int64_t>(column) * columns.levels() + level;
        sum += weight * ((1 - share[Dim - 1]) * above[0] + share[Dim - 1] * above[1]);
        weights += weight;
      }
    }
    return weights > 0 ? sum / weights : 0;
  }

 private:
  HOST_DEVICE float hat(float distance) const {
    const float w = 1 - fabsf(distance) / (reach + 1);
    return w > 0 ? w : 0;
  }
};

/// Particle pass: yield stress and apparent viscosity of a deposit; with states, bed load yields at the stress that
/// moves its grains, and suspended sediment is thickened water.
struct RheologyPass {
  Record* records;
  Sediment* sediment;
  const BedSurface* bed;  // nullptr: all sediment is deposit
  SedimentScene law;
  const float* excess_pore_pressure;  // [Pa], nullptr where the scene has none
  float solids_share;
  float einstein_coefficient;
  float water_viscosity;

  HOST_DEVICE void operator()(Index i) const {
    Record& r = records[i];
    if (r.phase != phase_sediment) return;
    Sediment& s = sediment[i];
    if (r.state == state_suspended) {
      s.yield_stress = 0;
      r.viscosity = suspension_viscosity(water_viscosity, solids_share * bed[i].concentration, einstein_coefficient);
      return;
    }
    if (excess_pore_pressure != nullptr) {
      const float carried = s.effective_pressure - excess_pore_pressure[i];
      s.effective_pressure = carried > 0 ? carried : 0;
    }
    s.yield_stress = r.state == state_bed_load ? bed[i].critical_stress : yield_stress_of(law, s);
    const float apparent = apparent_viscosity_of(law, s);
    r.viscosity = apparent > water_viscosity ? apparent : water_viscosity;
  }
};

/// Finds from where the sediment lies the slope of the bed over every sediment particle and, where the scene takes it
/// from the columns, the effective pressure; Laplace's equation starts from it.
template <int Dim, class Device>
void weigh_sediment(Device& on, Particles<Device>& p, const Scene<Dim>& scene, ColumnWeight<Device>& weight) {
  const ColumnLattice<Dim> columns(scene);
  const std::size_t nodes = static_cast<std::size_t>(columns.columns()) * static_cast<std::size_t>(columns.levels());
  weight.deposited.resize(nodes);
  weight.height_above.resize(nodes);
  weight.surface.resize(static_cast<std::size_t>(columns.columns()));
  weight.slope.resize(static_cast<std::size_t>(columns.columns()));
  weight.wetted.resize(static_cast<std::size_t>(columns.columns()));
  std::int64_t* deposited = weight.deposited.data();
  std::uint8_t* wetted = weight.wetted.data();
  const int levels = columns.levels();
  on.for_each(static_cast<Index>(columns.columns()), [=] HOST_DEVICE(Index column) {
    wetted[column] = 0;
    for (int level = 0; level < levels; ++level) deposited[static_cast<std::int64_t>(column) * levels + level] = 0;
  });
  const auto add = [] HOST_DEVICE(std::int64_t * to, std::int64_t amount) { Device::atomic_add(to, amount); };
  on.for_each(p.fluid_count,
              DepositPass<Dim, decltype(add)>{p.record.data(), p.position.data(), columns, deposited, wetted, add});
  const double column_area = std::pow(scene.spacing, Dim - 1);
  const auto spacing = static_cast<float>(scene.spacing);
  const auto reach = static_cast<float>(2 * scene.smoothing_length / scene.spacing);
  const auto all_columns = static_cast<Index>(columns.columns());
  on.for_each(all_columns,
              HeightAbovePass<Dim>{columns, deposited, weight.height_above.data(), weight.surface.data(),
                                   static_cast<float>(1 / (columns.quanta_per_volume * column_area)), spacing});
  on.for_each(all_columns, ColumnSlopePass<Dim>{columns, weight.surface.data(), weight.slope.data(), spacing,
                                                static_cast<int>(reach)});
  const EffectivePressure closure = scene.sediment.effective_pressure;
  const bool by_column = closure == EffectivePressure::column ||
                         (closure == EffectivePressure::laplace && largest_effective_pressure(on, p) == 0);
  on.for_each(p.fluid_count, EffectivePressurePass<Dim>{p.record.data(), p.position.data(), p.sediment.data(), columns,
                                                        weight.height_above.data(), weight.slope.data(), wetted,
                                                        scene.sediment, reach, by_column});
}

/// Particle pass over the bed: effective pressure as a share of the equation of state's.
template <int Dim, class Device>
void share_pressure_of_state(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  const Record* records = p.record.data();
  Sediment* sediment = p.sediment.data();
  const float pore_stiffness = scene.sediment.pore_stiffness;
  const float bed_stiffness = scene.stiffness(phase_sediment);
  on.for_each(p.fluid_count, [=] HOST_DEVICE(Index i) {
    const Record& r = records[i];
    if (r.phase != phase_sediment) return;
    sediment[i].effective_pressure = effective_pressure_of_state(r.pressure, pore_stiffness, bed_stiffness);
  });
}

/// Effective pressure where it changes with every step. Returns the sweeps that Laplace's equation took.
template <int Dim, class Device>
int solve_effective_pressure(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  switch (scene.sediment.effective_pressure) {
    case EffectivePressure::column:
      break;
    case EffectivePressure::laplace:
      return solve_laplace_pressure(on, p, scene);
    case EffectivePressure::eos:
      share_pressure_of_state(on, p, scene);
      break;
  }
  return 0;
}

template <int Dim, class Device>
void apply_rheology(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  const RheologyPass pass{p.record.data(),
                          p.sediment.data(),
                          scene.has_states ? p.bed.data() : nullptr,
                          scene.sediment,
                          scene.seepage.pore_pressure ? p.excess_pore_pressure.data() : nullptr,
                          scene.erosion.solids_share,
                          scene.erosion.einstein_coefficient,
                          scene.water_viscosity};
  for_each_member(on, p.list(), p.near_sediment(), pass);
  if (p.any_resting) for_each_member(on, p.list(), p.shore(), pass);
}

}  // namespace thalweg
