#pragma once

#include "solver/simulation/input.hpp"

namespace thalweg {

/// Of each GPU where several ranks have one each. `particles` are all of the scene.
GpuMemory estimate_gpu_memory(const AnyScene& scene, const ParticleSet& particles, int ranks = 1);

/// Refuses a scene that GPUs with so many free bytes each cannot hold: throws InputError that names the smallest spacing
/// which fits.
void require_gpu_memory(const AnyScene& scene, const GpuMemory& memory, double available, int ranks = 1);

/// True if the coefficients fit into the free memory too, with a fifth of it to spare.
bool coefficients_fit(const GpuMemory& memory, double available);

}  // namespace thalweg
