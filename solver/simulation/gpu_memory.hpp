#pragma once

#include "solver/simulation/input.hpp"

namespace thalweg {

/// Memory that a scene takes on a GPU at its peak [bytes], and how many entries its neighbour lists have: estimates from the
/// declarations of its arrays, before anything is allocated.
struct GpuMemory {
  double needed = 0;        // without the viscous pair coefficients
  double coefficients = 0;  // more, if they are stored
  double entries = 0;       // of the neighbour lists [-]
};
/// Of each GPU where several ranks have one each. Each loads all particles once, before it keeps its share.
GpuMemory estimate_gpu_memory(const AnyScene& scene, const ParticleSet& particles, int ranks = 1);

/// Refuses a scene that GPUs with so many free bytes each cannot hold: throws InputError that names the smallest spacing
/// which fits.
void require_gpu_memory(const AnyScene& scene, const ParticleSet& particles, double available, int ranks = 1);

/// True if the coefficients fit into the free memory too, with a fifth of it to spare.
bool coefficients_fit(const GpuMemory& memory, double available);

}  // namespace thalweg
