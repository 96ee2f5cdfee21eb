#pragma once

#include <cmath>

#include "solver/backend/buffer.hpp"
#include "solver/models/all.hpp"

// Memory of a simulation: what it takes, and what it will take, both from the declarations of its arrays.
namespace thalweg {

/// Bytes that the particles' arrays, the lists and the models' buffers take on the device.
template <int Dim, class Device>
std::size_t bytes_of(Particles<Device>& p, const Scene<Dim>& scene, const Workspace<Device>& work) {
  std::size_t bytes = p.record.size() * sizeof(Record) + p.listed_at.size() * sizeof(Place) +
                      (p.list_begin.size() + p.list_entries.size()) * sizeof(Index) +
                      p.drift_cells.size() * sizeof(DriftCell) +
                      (p.drift_of_block.size() + p.drift_of_cell.size()) * sizeof(DriftBox) + work.bytes();
  EachArray add(scratch,
                [&](const Field&, auto& buffer, const auto& newborn) { bytes += buffer.size() * sizeof(newborn); });
  p.describe(scene, add);
  return bytes;
}

/// Stands for a GPU where only sizes matter.
struct GpuSizes {
  template <class T>
  using Buffer = HostBuffer<T>;
  using PairCoefficient = ShortFloat;
};

/// Bytes a particle will take on a device that computes pair coefficients again (a GPU): its arrays, its share of a
/// cluster's list, and what sorting needs while it lasts.
template <class Device, int Dim>
double bytes_per_particle(const Scene<Dim>& scene) {
  Particles<Device> none;
  double arrays = sizeof(Record) + sizeof(Place);
  double largest = sizeof(Record);
  EachArray add(scratch, [&](const Field&, auto&, const auto& newborn) {
    arrays += sizeof(newborn);
    largest = std::fmax(largest, double(sizeof(newborn)));
  });
  none.describe(scene, add);
  // A cluster's list reaches as far around four particles, which lie within a spacing or so of their middle.
  constexpr double pi = 3.14159265358979323846;
  const double reach = scene.list_reach / scene.spacing + (Dim == 2 ? 0.6 : 0.8);
  const double in_reach = Dim == 2 ? pi * reach * reach : 4.0 / 3.0 * pi * reach * reach * reach;
  const double lists = in_reach / cluster_size * sizeof(Index);
  const double solve = scene.has_sediment ? sizeof(typename ViscousSystem<Device>::Row) : 0;
  const double sorting = 2 * (sizeof(std::uint64_t) + sizeof(Index)) + largest;
  return arrays + lists + solve + sorting;
}

}  // namespace thalweg
