#pragma once

#include <cmath>

#include "solver/particles.hpp"
#include "solver/physics/herschel_bulkley.hpp"

// The sediment's strength: effective pressure = submerged weight of the sediment above, yield stress by Drucker-Prager,
// apparent viscosity by Herschel-Bulkley-Papanastasiou. The dynamic pressure of the water does not enter: it would turn
// wave impact into strength (docs/theory.md).
namespace thalweg {

/// Volume of sediment above each node of a lattice of columns one spacing apart. Volumes are summed as integers, so
/// that the result does not depend on the order of the particles.
template <class Device>
struct ColumnWeight {
  typename Device::template Buffer<std::int64_t> deposited;  // per node, in volume quanta
  typename Device::template Buffer<float> height_above;      // per node [m]
  typename Device::template Buffer<std::uint8_t> wetted;     // per column: any fluid here
};

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

/// Pass over the columns: height of sediment above each node, its own half included.
template <int Dim>
struct HeightAbovePass {
  ColumnLattice<Dim> columns;
  const std::int64_t* deposited;
  float* height_above;
  float height_per_quantum;  // [m]

  HOST_DEVICE void operator()(Index column) const {
    const int levels = columns.levels();
    const std::int64_t base = static_cast<std::int64_t>(column) * levels;
    std::int64_t above = 0;
    for (int level = levels - 1; level >= 0; --level) {
      const std::int64_t own = deposited[base + level];
      height_above[base + level] = static_cast<float>(2 * above + own) * (0.5F * height_per_quantum);
      above += own;
    }
  }
};

/// Particle pass: effective pressure, yield stress, viscosity. The height above is averaged over the wetted columns
/// within a support to either side, so that single particles at the surface do not make steps of strength.
template <int Dim>
struct StrengthPass {
  Record* records;
  const Position* positions;
  Sediment* sediment;
  ColumnLattice<Dim> columns;
  const float* height_above;
  const std::uint8_t* wetted;
  Scene<Dim> scene;
  float reach;                        // of the average, in spacings
  const float* excess_pore_pressure;  // [Pa], nullptr where the scene has none

  HOST_DEVICE void operator()(Index i) const {
    Record& r = records[i];
    if (r.phase != phase_sediment) return;
    const SedimentScene& law = scene.sediment;
    Sediment& s = sediment[i];
    s.effective_pressure = law.submerged_weight * mean_height_above(i);
    if (excess_pore_pressure != nullptr) {
      const float carried = s.effective_pressure - excess_pore_pressure[i];
      s.effective_pressure = carried > 0 ? carried : 0;
    }
    s.yield_stress = law.yield_coefficient * s.effective_pressure + law.yield_cohesion;
    r.viscosity =
        herschel_bulkley_viscosity(s.strain_rate, s.yield_stress, law.regularisation, law.consistency, law.flow_index);
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

template <int Dim, class Device>
void update_sediment_strength(Device& on, Particles<Device>& p, const Scene<Dim>& scene, ColumnWeight<Device>& weight) {
  const ColumnLattice<Dim> columns(scene);
  const std::size_t nodes = static_cast<std::size_t>(columns.columns()) * static_cast<std::size_t>(columns.levels());
  weight.deposited.resize(nodes);
  weight.height_above.resize(nodes);
  weight.wetted.resize(static_cast<std::size_t>(columns.columns()));
  std::int64_t* deposited = weight.deposited.data();
  std::uint8_t* wetted = weight.wetted.data();
  const int levels = columns.levels();
  on.for_each(static_cast<Index>(columns.columns()), [=](Index column) {
    wetted[column] = 0;
    for (int level = 0; level < levels; ++level) deposited[static_cast<std::int64_t>(column) * levels + level] = 0;
  });
  const auto add = [](std::int64_t* to, std::int64_t amount) { Device::atomic_add(to, amount); };
  on.for_each(p.fluid_count,
              DepositPass<Dim, decltype(add)>{p.record.data(), p.position.data(), columns, deposited, wetted, add});
  const double column_area = std::pow(scene.spacing, Dim - 1);
  on.for_each(static_cast<Index>(columns.columns()),
              HeightAbovePass<Dim>{columns, deposited, weight.height_above.data(),
                                   static_cast<float>(1 / (columns.quanta_per_volume * column_area))});
  const auto reach = static_cast<float>(2 * scene.smoothing_length / scene.spacing);
  on.for_each(p.fluid_count, StrengthPass<Dim>{p.record.data(), p.position.data(), p.sediment.data(), columns,
                                               weight.height_above.data(), wetted, scene, reach,
                                               scene.seepage.pore_pressure ? p.excess_pore_pressure.data() : nullptr});
}

}  // namespace thalweg
