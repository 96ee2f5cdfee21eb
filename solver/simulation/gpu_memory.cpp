#include "solver/simulation/gpu_memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "common/error.hpp"
#include "common/memory.hpp"
#include "common/units.hpp"
#include "solver/backend/list_limit.hpp"
#include "solver/lists/team_search.hpp"
#include "solver/simulation/memory.hpp"
#include "solver/simulation/snapshot.hpp"

namespace thalweg {
namespace {

/// Stands for a GPU where only sizes matter.
struct GpuSizes {
  template <class T>
  using Buffer = HostBuffer<T>;
  using PairCoefficient = ShortFloat;
};

/// Visitor: bytes a particle that a snapshot shows.
struct ShownBytes {
  double bytes = sizeof(SnapshotParticle);
  template <class Buffer, class T>
  void array(const Field&, Buffer&, ArrayTraits, const T&) {}
  template <class Buffer>
  void shown(const char*, const Buffer&) {
    bytes += sizeof(float);
  }
  template <class Buffer, class Member>
  void shown(const char*, const Buffer&, Member, const ShownAs& = {}) {
    bytes += sizeof(float);
  }
  void shown_kind(const char*, float (*)(float)) {}
};

/// Particles, and list cells of the box around them.
struct Counts {
  double all = 0;
  double cells = 0;
};

bool is_wall_type(ParticleType type) { return type == ParticleType::wall || type == ParticleType::moving_wall; }

template <int Dim>
Counts count(const Scene<Dim>& scene, const ParticleSet& particles) {
  Counts n;
  n.all = static_cast<double>(particles.size());
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    box.extend(particles.position[i]);
  }
  n.cells = particles.size() == 0 ? 0 : 1;
  for (int k = 0; k < Dim && particles.size() > 0; ++k) {
    const double width = scene.lattice.range[k] / scene.lattice.cells[k];
    n.cells *= std::floor(box.sizes()[axis<Dim>(k)] / width) + 1;
  }
  return n;
}

/// Some of the particles, and how many others lie in a reach [m] of each.
class Samples {
 public:
  Samples(const ParticleSet& particles, double reach) : of_(particles), reach_(reach) {
    const std::size_t stride = std::max<std::size_t>(1, particles.size() / 1000);
    for (std::size_t i = 0; i < particles.size(); i += stride) {
      const Cell at = cell_of(i);
      for (int n = 0; n < 27; ++n) near_[{at[0] + n % 3 - 1, at[1] + n / 3 % 3 - 1, at[2] + n / 9 - 1}].push_back(i);
      ++number_;
    }
  }

  /// Mean number of those in reach that a list would have: a wall lists the fluid alone.
  [[nodiscard]] double mean_listed() const {
    double listed = 0;
    for (std::size_t j = 0; j < of_.size(); ++j) {
      const auto found = near_.find(cell_of(j));
      if (found == near_.end()) continue;
      for (const std::size_t i : found->second) {
        const bool in_reach = (of_.position[i] - of_.position[j]).squaredNorm() < reach_ * reach_;
        if (in_reach && !(is_wall(i) && is_wall(j))) ++listed;
      }
    }
    return number_ == 0 ? 0 : listed / number_;
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  [[nodiscard]] Cell cell_of(std::size_t i) const {
    Cell cell{};
    for (int c = 0; c < 3; ++c) cell[c] = static_cast<std::int64_t>(std::floor(of_.position[i][c] / reach_));
    return cell;
  }
  [[nodiscard]] bool is_wall(std::size_t i) const { return is_wall_type(of_.type[i]); }

  const ParticleSet& of_;
  double reach_;
  double number_ = 0;
  std::map<Cell, std::vector<std::size_t>> near_;
};

/// Entries of all lists. A cluster is a square or so of four particles, a spacing wide: as much lies in reach of it as around
/// one particle in a reach that is longer by this share of a spacing (counted: gpu_memory_test). A list is padded by 1.5 on
/// average.
template <int Dim>
double entries_of(const Scene<Dim>& scene, const ParticleSet& particles) {
  constexpr double longer = 0.8;
  const double listed = Samples(particles, scene.list_reach + longer * scene.spacing).mean_listed();
  return (listed + 1.5) / cluster_size * static_cast<double>(particles.size());
}

/// Bytes a particle while particles are sorted: keys and order twice, or the order and a second copy of one array.
double sorting_bytes(double largest_array) {
  const double keys = 2 * (sizeof(std::uint64_t) + sizeof(Index));
  return std::max(keys, sizeof(Index) + largest_array);
}

template <int Dim>
GpuMemory estimate(const Scene<Dim>& scene, const ParticleSet& particles, int ranks) {
  Particles<GpuSizes> none;
  double arrays = sizeof(Record) + sizeof(Place);
  double largest = sizeof(Record);
  EachArray add(scratch, [&](const Field&, auto&, const auto& newborn) {
    arrays += sizeof(newborn);
    largest = std::max(largest, double(sizeof(newborn)));
  });
  none.describe(scene, add);
  ShownBytes shown;
  none.describe(scene, shown);

  const Counts n = count(scene, particles);
  GpuMemory memory;
  memory.particles = n.all;
  memory.entries = entries_of(scene, particles);
  // The beginnings of the lists, the nine lists of clusters, which have room for all, and the clusters' marks.
  const double clusters = n.all / cluster_size;
  const double of_clusters = clusters * ((1 + 9) * sizeof(Index) + 1);
  const double lists = memory.entries * sizeof(Index) * 17 / 16 + of_clusters;  // DeviceBuffer::resize_anew
  const double drift = n.cells * (sizeof(DriftCell) + sizeof(DriftBox) * (1 + std::pow(0.5, Dim)));
  double lattices = 0;
  AllModels::each([&]<class M>() {
    if constexpr (requires { M::lattice_bytes(scene, n.all); }) {
      if (M::is_on(scene)) lattices += M::lattice_bytes(scene, n.all);
    }
  });
  const double building = n.all * sizeof(neighbours::PlaceQuad) +
                          clusters * (neighbours::kept_words<Dim> * sizeof(std::uint32_t) + sizeof(Index)) + n.all +
                          n.cells * 4 * sizeof(Index);
  const double making_lists = std::max(n.all * sorting_bytes(largest), building);
  memory.needed = n.all * (arrays + shown.bytes) + lists + drift + making_lists;
  if (ranks > 1) {
    memory.entries /= ranks;
    memory.needed /= ranks;
  }
  memory.needed += lattices;  // whole on every rank
  if (!scene.has_sediment || scene.viscosity != ViscosityTreatment::implicit) return memory;
  const double coefficients =
      memory.entries * 17 / 16 * cluster_size * sizeof(GpuSizes::PairCoefficient) + n.all * sizeof(Vectors) / ranks;
  const bool needs_them = scene.bed_load.on || scene.seepage.mixture;  // Coupling::needs_stored
  (needs_them ? memory.needed : memory.coefficients) += coefficients;
  return memory;
}

}  // namespace

GpuMemory estimate_gpu_memory(const AnyScene& scene, const ParticleSet& particles, int ranks) {
  return std::visit([&](const auto& of) { return estimate(of, particles, ranks); }, scene);
}

void require_gpu_memory(const AnyScene& scene, const GpuMemory& memory, double available, int ranks) {
  const auto [spacing, dimension] = std::visit(
      [](const auto& of) {
        return std::pair{of.spacing, std::is_same_v<std::decay_t<decltype(of)>, Scene<3>> ? 3 : 2};
      },
      scene);
  if (memory.needed > available) {
    throw InputError(
        fmt::format("--backend cuda: {:.3g} particles need {} on {}, which has {} free; fill the scene with a spacing "
                    "of {} or more (numerics.spacing), or use --backend openmp",
                    memory.particles, format_bytes(memory.needed), ranks > 1 ? "each rank's GPU" : "the GPU",
                    format_bytes(available),
                    format_quantity(spacing_that_fits(spacing, memory.needed, available, dimension), "m")));
  }
  const auto most = static_cast<double>(most_list_entries);
  if (memory.entries > most) {
    throw InputError(
        fmt::format("--backend cuda: {:.3g} particles have {:.3g} entries in their neighbour lists, which can hold "
                    "{:.3g}; fill the scene with a spacing of {} or more (numerics.spacing)",
                    memory.particles, memory.entries, most,
                    format_quantity(spacing_that_fits(spacing, memory.entries, most, dimension), "m")));
  }
}

bool coefficients_fit(const GpuMemory& memory, double available) {
  return memory.coefficients > 0 && memory.needed + memory.coefficients < 0.8 * available;
}

}  // namespace thalweg
