#include "common/extraction/volume_fraction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "physics/kernel.hpp"

namespace thalweg {
namespace {

// The range of grid indices within `reach` of a coordinate, clipped to [first, last).
struct IndexRange {
  std::size_t begin;
  std::size_t end;
};
IndexRange indices_within(double coordinate, double reach, double step, long origin, std::size_t first,
                          std::size_t last) {
  const auto clip = [&](double index) {
    return static_cast<std::size_t>(
        std::clamp(index - static_cast<double>(origin), static_cast<double>(first), static_cast<double>(last)));
  };
  return {clip(std::ceil((coordinate - reach) / step)), clip(std::floor((coordinate + reach) / step) + 1)};
}

// Adds one particle's shares along a column: `height` [m] of node 0 over the particle, `aside2` [m^2] squared distance
// of the column. The loop has no branch and counts in int, which is a float in one instruction, so that the compiler
// takes several nodes at a time; nodes out of reach get 0.
template <class Kernel>
void add_along_column(float* nodes, IndexRange rows, const Kernel& kernel, float volume, float height, float step,
                      float aside2) {
  const int end = static_cast<int>(rows.end);
  for (int k = static_cast<int>(rows.begin); k < end; ++k) {
    const float dz = height + step * static_cast<float>(k);
    nodes[k] += volume * kernel.value(kernel.closeness(std::sqrt(aside2 + dz * dz)));
  }
}

// Adds particles to sums in which water, moving and resting sediment do not overlap.
template <int Dim>
class Scatter {
 public:
  Scatter(VolumeFractions& sums, const ClassifiedParticles& set)
      : sums_(sums),
        particles_(set.particles),
        parts_(set.parts),
        walls_(set.walls),
        kernel_(static_cast<float>(particles_.info.smoothing_length)),
        reach_(2 * particles_.info.smoothing_length),
        lattice_volume_(static_cast<float>(std::pow(particles_.info.spacing, Dim))),
        has_volumes_(!particles_.mass.empty() && !particles_.density.empty()) {}

  void add(std::size_t b, std::size_t first_column, std::size_t last_column) {
    if (walls_.doubled[b] != 0) return;
    const SamplingGrid& grid = sums_.grid;
    const Vec3& at = particles_.position[b];
    const bool plane = grid.is_plane();
    if (Dim == 3 && plane && std::abs(grid.plane_y - at.y()) > reach_) return;
    const IndexRange across = indices_within(at.x(), reach_, grid.step, grid.first_x, first_column, last_column);
    const IndexRange along =
        plane ? IndexRange{0, 1} : indices_within(at.y(), reach_, grid.step, grid.first_y, 0, grid.ny);
    const IndexRange rows = indices_within(at.z(), reach_, grid.step, grid.first_z, 0, grid.nz);
    for (const Target& target : targets_of(b, rows)) {
      if (target.rows.begin >= target.rows.end) continue;
      for (std::size_t i = across.begin; i < across.end; ++i) {
        const double dx = grid.x(i) - at.x();
        for (std::size_t j = along.begin; j < along.end; ++j) {
          const double dy = Dim == 2 ? 0 : grid.y(j) - at.y();
          add_to_column(b, target, grid.column(i, j), dx * dx + dy * dy);
        }
      }
    }
  }

 private:
  // A sum to which a particle contributes, and the rows of its nodes.
  struct Target {
    std::vector<float>& sum;
    IndexRange rows;
  };

  [[nodiscard]] std::array<Target, 2> targets_of(std::size_t b, IndexRange rows) {
    const auto all_in = [&](std::vector<float>& sum) {
      return std::array{Target{sum, rows}, Target{sum, {rows.end, rows.end}}};
    };
    switch (parts_[b]) {
      case Part::water:
        return all_in(sums_.fluid);
      case Part::moving_sediment:
        return all_in(sums_.sediment);
      case Part::resting_sediment:
        return all_in(sums_.resting);
      case Part::wall:
        break;
    }
    // A node exactly a spacing below the face belongs to the floor, whichever way its height was rounded.
    const double depth = 1.01 * particles_.info.spacing;
    std::size_t floor_from = rows.begin;
    while (floor_from < rows.end && walls_.top[b] > sums_.grid.z(floor_from) + depth) ++floor_from;
    return {Target{sums_.side, {rows.begin, floor_from}}, Target{sums_.floor, {floor_from, rows.end}}};
  }

  void add_to_column(std::size_t b, const Target& target, std::size_t column, double aside2) {
    if (aside2 >= reach_ * reach_) return;
    const SamplingGrid& grid = sums_.grid;
    add_along_column(&target.sum[grid.node(column, 0)], target.rows, kernel_, volume_of(b),
                     static_cast<float>(grid.z(0) - particles_.position[b].z()), static_cast<float>(grid.step),
                     static_cast<float>(aside2));
  }

  // A wall particle has the volume of its lattice cell, because its mass and density are not those of a material.
  [[nodiscard]] float volume_of(std::size_t b) const {
    const bool known = parts_[b] != Part::wall && has_volumes_ && particles_.density[b] > 0;
    return known ? particles_.mass[b] / particles_.density[b] : lattice_volume_;
  }

  VolumeFractions& sums_;
  const ParticleSet& particles_;
  const std::vector<Part>& parts_;
  const WallRuns& walls_;
  WendlandC2<Dim, float> kernel_;
  double reach_;
  float lattice_volume_;
  bool has_volumes_;
};

template <int Dim>
void add_all(VolumeFractions& sums, const ClassifiedParticles& set, std::span<const std::size_t> which,
             std::size_t first_column, std::size_t last_column) {
  Scatter<Dim> scatter(sums, set);
  for (const std::size_t b : which) scatter.add(b, first_column, last_column);
}

}  // namespace

VolumeFractions::VolumeFractions(const SamplingGrid& nodes) : grid(nodes) {
  for (auto* field : {&fluid, &sediment, &resting, &floor, &side}) field->assign(grid.size(), 0);
}

void add_volume_fractions(VolumeFractions& sums, const ClassifiedParticles& set, std::span<const std::size_t> which,
                          std::size_t first_column, std::size_t last_column) {
  const auto add = set.particles.info.dimension == 2 ? add_all<2> : add_all<3>;
  add(sums, set, which, first_column, last_column);
  // The three were summed apart. Now fluid includes sediment, and sediment includes what rests.
  const SamplingGrid& grid = sums.grid;
  for (std::size_t node = grid.node(grid.column(first_column, 0), 0); node < grid.node(grid.column(last_column, 0), 0);
       ++node) {
    sums.sediment[node] += sums.resting[node];
    sums.fluid[node] += sums.sediment[node];
  }
}

VolumeFractions sum_volume_fractions(const ClassifiedParticles& set, const SamplingGrid& grid) {
  VolumeFractions sums(grid);
  std::vector<std::size_t> all(set.particles.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  add_volume_fractions(sums, set, all, 0, grid.nx);
  return sums;
}

}  // namespace thalweg
