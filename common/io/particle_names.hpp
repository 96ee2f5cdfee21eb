#pragma once

#include <array>

/// Names of the facts in a particle file's field data (docs/file-formats.md). The names of its arrays stand in
/// common/particle_arrays.hpp.
namespace thalweg::particle_names {

inline constexpr const char* mass = "Mass";  // a mass that all particles have; otherwise an array of the same name
inline constexpr const char* case_name = "CaseName";
inline constexpr const char* version = "CodeVersion";
inline constexpr const char* hash = "CaseHash";
inline constexpr const char* dimension = "Dimension";
inline constexpr const char* spacing = "Spacing";
inline constexpr const char* smoothing = "SmoothingLength";
inline constexpr const char* time = "TimeValue";
inline constexpr const char* step = "Step";
inline constexpr const char* lattice_node = "LatticeNode";
inline constexpr const char* count =
    "NumberOfParticles";  // that were written: tells a file of which some were taken out

/// The facts that are numbers of ParticleFileInfo or ParticleSet; further ones are ParticleSet::facts.
inline constexpr std::array<const char*, 7> numbers{mass, dimension, spacing, smoothing, time, step, lattice_node};

}  // namespace thalweg::particle_names
