#pragma once

#include "solver/models/bed/arrays.hpp"
#include "solver/models/bed/bed_slope.hpp"
#include "solver/models/bed/column_surface.hpp"
#include "solver/models/bed/laplace_pressure.hpp"

// Effective pressure = submerged weight of the sediment above (or what the scene has chosen). The dynamic pressure of
// the water does not enter: it would turn wave impact into strength (docs/theory.md). Weights follow the places of the
// particles and are taken anew when the neighbour lists are; until then no particle has moved by more than half the
// lists' skin.
namespace thalweg {

/// Particle pass: slope of the bed and, where the columns say it, effective pressure gamma' z cos^2(beta): the pressure
/// normal to a surface of slope beta, so that an infinite slope stands up to tan(beta) = K. The height z is averaged
/// over the wetted columns within a support to either side, so that single particles at the surface do not make steps
/// of strength; beta is counted up to the friction angle, what is steeper slides.
template <int Dim>
struct EffectivePressurePass {
  using reads = Reads<field::matter, field::position>;
  using writes = Writes<field::sediment>;

  const Record* records;
  const Position* positions;
  Sediment* sediment;
  ColumnLattice<Dim> columns;
  const float* height_above;
  const float* slope;
  const std::uint8_t* wetted;
  const std::uint8_t* under_water;
  SedimentScene law;
  float reach;     // of the average, in spacings
  bool by_column;  // the effective pressure is the columns'

  HOST_DEVICE void operator()(Index i) const {
    if (!is_sediment(records[i])) return;
    Sediment& s = sediment[i];
    s.bed_slope = slope_at(i);
    const float t = s.bed_slope < law.friction_tangent ? s.bed_slope : law.friction_tangent;
    if (by_column) {
      const Above above = mean_above(i);
      s.effective_pressure = effective_pressure_of_column(law.submerged_weight, above.height, 1 / (1 + t * t)) +
                             above.emerged * law.suction;
    }
  }

  HOST_DEVICE float slope_at(Index i) const {
    const int column = columns.nearest_column(positions[i]);
    return column < 0 ? 0 : slope[column];
  }

  /// Means over the columns around.
  struct Above {
    float height = 0;   // of the bed [m]
    float emerged = 0;  // share of the columns without water [-]
  };

  [[nodiscard]] HOST_DEVICE Above mean_above(Index i) const {
    float share[Dim];
    int node[Dim];
    for (int k = 0; k < Dim; ++k) node[k] = columns.below(k, positions[i].x[axis<Dim>(k)], share[k]);
    const int level = node[Dim - 1];
    if (level < 0 || level + 1 >= columns.levels()) return {};
    const int around = static_cast<int>(reach);
    Above sum;
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
        sum.height += weight * ((1 - share[Dim - 1]) * above[0] + share[Dim - 1] * above[1]);
        sum.emerged += under_water[column] == 0 ? weight : 0;
        weights += weight;
      }
    }
    if (!(weights > 0)) return {};
    return {sum.height / weights, sum.emerged / weights};
  }

 private:
  HOST_DEVICE float hat(float distance) const {
    const float w = 1 - fabsf(distance) / (reach + 1);
    return w > 0 ? w : 0;
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
  weight.under_water.resize(static_cast<std::size_t>(columns.columns()));
  weight.content.resize(nodes);
  weight.covered.resize(static_cast<std::size_t>(columns.columns()));
  std::int64_t* deposited = weight.deposited.data();
  std::uint8_t* wetted = weight.wetted.data();
  std::uint8_t* under_water = weight.under_water.data();
  std::uint8_t* content = weight.content.data();
  std::uint8_t* covered = weight.covered.data();
  float* surface = weight.surface.data();
  const int levels = columns.levels();
  on.for_each(static_cast<Index>(columns.columns()), declare<Reads<>, Writes<>>([=] HOST_DEVICE(Index column) {
                wetted[column] = 0;
                under_water[column] = 0;
                for (int level = 0; level < levels; ++level) {
                  deposited[static_cast<std::int64_t>(column) * levels + level] = 0;
                  content[static_cast<std::int64_t>(column) * levels + level] = column_node::empty;
                }
              }));
  const auto add = [] HOST_DEVICE(std::int64_t * to, std::int64_t amount) { Device::atomic_add(to, amount); };
  const Position* positions = p.position.data();
  on.for_each(p.fluid_count, DepositPass<Dim, decltype(add)>{p.record.data(), positions, columns, deposited, wetted,
                                                             under_water, content, add});
  const MarkWallsPass<Dim> mark_walls{positions, columns, content};
  const Record* records = p.record.data();
  on.for_each(p.count, declare<Reads<field::matter, field::position>, Writes<>>([=] HOST_DEVICE(Index i) {
                if (is_wall(records[i])) mark_walls(i);
              }));
  on.share_sums(weight.deposited);
  for (auto* marks : {&weight.wetted, &weight.under_water, &weight.content}) on.share_marks(*marks);
  const double column_area = std::pow(scene.spacing, Dim - 1);
  const auto spacing = static_cast<float>(scene.spacing);
  const auto reach = static_cast<float>(2 * scene.smoothing_length / scene.spacing);
  const auto all_columns = static_cast<Index>(columns.columns());
  const ColumnWalk first{deposited, content, static_cast<float>(1 / (columns.quanta_per_volume * column_area)),
                         spacing};
  on.for_each(all_columns, ColumnSurfacePass<Dim>{columns, first, surface, covered});
  on.for_each(all_columns, CoveredSurfacePass<Dim>{columns, covered, surface});
  on.for_each(all_columns, HeightAbovePass<Dim>{columns, first, surface, covered, weight.height_above.data()});
  on.for_each(all_columns,
              ColumnSlopePass<Dim>{columns, surface, weight.slope.data(), spacing, static_cast<int>(reach)});
  const EffectivePressure closure = scene.sediment.effective_pressure;
  const bool by_column = closure == EffectivePressure::column ||
                         (closure == EffectivePressure::laplace && largest_effective_pressure(on, p) == 0);
  on.for_each(p.fluid_count,
              EffectivePressurePass<Dim>{records, positions, p.sediment.data(), columns, weight.height_above.data(),
                                         weight.slope.data(), wetted, under_water, scene.sediment, reach, by_column});
}

/// Particle pass over the bed: effective pressure as a share of the equation of state's.
template <int Dim, class Device>
void share_pressure_of_state(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  const Record* records = p.record.data();
  Sediment* sediment = p.sediment.data();
  const float pore_stiffness = scene.sediment.pore_stiffness;
  const float bed_stiffness = scene.stiffness(kind::deposit);
  on.for_each(p.fluid_count,
              declare<Reads<field::flow, field::matter>, Writes<field::sediment>>([=] HOST_DEVICE(Index i) {
                const Record& r = records[i];
                if (!is_sediment(r)) return;
                sediment[i].effective_pressure = effective_pressure_of_state(r.pressure, pore_stiffness, bed_stiffness);
              }));
}

/// Particle pass over the bed: all of a particle's pressure. That of a mixture's grains is theirs alone; that of a bed of
/// one fluid holds the water's, as the paper prints it.
template <class Device>
void take_pressure_of_state(Device& on, Particles<Device>& p) {
  const Record* records = p.record.data();
  Sediment* sediment = p.sediment.data();
  on.for_each(p.fluid_count,
              declare<Reads<field::flow, field::matter>, Writes<field::sediment>>([=] HOST_DEVICE(Index i) {
                const Record& r = records[i];
                if (is_sediment(r)) sediment[i].effective_pressure = r.pressure > 0 ? r.pressure : 0;
              }));
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
    case EffectivePressure::total:
    case EffectivePressure::grains:
      take_pressure_of_state(on, p);
      break;
  }
  return 0;
}

}  // namespace thalweg
