#pragma once

/// Names of the arrays and facts in a particle file (docs/file-formats.md).
namespace thalweg::particle_names {

inline constexpr const char* id = "Id";
inline constexpr const char* type = "Type";
inline constexpr const char* state = "State";
inline constexpr const char* velocity = "Velocity";
inline constexpr const char* density = "Density";
inline constexpr const char* pressure = "Pressure";
inline constexpr const char* mass = "Mass";
inline constexpr const char* viscosity = "Viscosity";
inline constexpr const char* normal = "Normal";
inline constexpr const char* case_name = "CaseName";
inline constexpr const char* version = "CodeVersion";
inline constexpr const char* hash = "CaseHash";
inline constexpr const char* dimension = "Dimension";
inline constexpr const char* spacing = "Spacing";
inline constexpr const char* smoothing = "SmoothingLength";
inline constexpr const char* time = "TimeValue";
inline constexpr const char* step = "Step";

}  // namespace thalweg::particle_names
