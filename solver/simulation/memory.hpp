#pragma once

#include "solver/models/all.hpp"

// Memory that a simulation takes, from the declarations of its arrays.
namespace thalweg {

/// Bytes that the particles' arrays, the lists and the models' buffers take on the device.
template <int Dim, class Device>
std::size_t bytes_of(Particles<Device>& p, const Scene<Dim>& scene, const Workspace<Device>& work) {
  std::size_t bytes = p.record.size() * sizeof(Record) + p.listed_at.size() * sizeof(Place) +
                      (p.list_begin.size() + p.list_entries.size()) * sizeof(Index) + p.cluster_marks.size() +
                      p.drift_cells.size() * sizeof(DriftCell) +
                      (p.drift_of_block.size() + p.drift_of_cell.size()) * sizeof(DriftBox) + work.bytes();
  EachArray add(scratch,
                [&](const Field&, auto& buffer, const auto& newborn) { bytes += buffer.size() * sizeof(newborn); });
  p.describe(scene, add);
  return bytes;
}

}  // namespace thalweg
