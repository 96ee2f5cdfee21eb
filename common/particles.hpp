#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace thalweg {

using Vec3 = Eigen::Vector3d;

/// Material of a particle. The numbers are part of the file format (docs/file-formats.md).
enum class ParticleType : std::uint8_t { wall = 0, moving_wall = 1, water = 2, sediment = 3 };

/// State of motion of a sediment particle; `none` for every other type. Part of the file format.
enum class SedimentState : std::uint8_t { none = 0, deposit = 1, bed_load = 2, suspended = 3 };

/// Name of the array (ParticleSet::scalars) with the number of a wall particle's motion, counted from 1 in the order of
/// the case; 0 for particles without a motion. Absent without moving walls.
inline constexpr const char* motion_array = "Motion";

/// Name of the array with the roughness of a wall particle [m], its shape's; 0 for other particles. Absent where all walls
/// are smooth.
inline constexpr const char* roughness_array = "Roughness";

/// Name of the array with the volume share of grains in a water particle [-]; of a bed particle 1. Absent where no water
/// carries grains.
inline constexpr const char* concentration_array = "Concentration";

/// Facts about a whole particle file, stored as FieldData. A program that writes on what it has read copies this
/// struct, so that every fact passes through snapshots, checkpoints and restarts.
struct ParticleFileInfo {
  std::string case_name;
  std::string code_version;     // of the program that wrote the file
  std::string case_hash;        // of the resolved case (hash_of(Case))
  int dimension = 2;            // 2 (plane x-z, y = 0) or 3
  double spacing = 0;           // [m]
  double smoothing_length = 0;  // [m]
  double time = 0;              // [s], written as TimeValue so that ParaView shows seconds
  std::int64_t step = 0;        // [-]
  /// [m] One node of the lattice the particles started on, as gencase says it; absent in files of other origin.
  std::optional<Vec3> lattice_node = std::nullopt;
};

/// A set of particles on the host: structure of arrays, SI units. Every array is empty or has one entry for each of the
/// size() particles (`scalars` and `doubles`: one or more components each); `id`, `type` and `position` are never empty
/// unless the set is.
///
/// An array that only a model or a program knows belongs into `scalars` or `doubles`: it is written and read under its
/// key, and no list of names has to be extended. The arrays that are members of their own are listed once, in
/// common/particle_arrays.hpp.
struct ParticleSet {
  ParticleFileInfo info;

  std::vector<std::int64_t> id;  // global, unique, kept for life
  std::vector<ParticleType> type;
  std::vector<SedimentState> state;       // empty without sediment
  std::vector<Vec3> position;             // [m]; y = 0 in 2-D
  std::vector<Eigen::Vector3f> velocity;  // [m/s]
  std::vector<float> density;             // [kg/m^3]
  std::vector<float> pressure;            // [Pa]
  std::vector<float> mass;                // [kg] (2-D: [kg/m])
  std::vector<float> viscosity;           // [Pa s]; only if the model has one per particle
  std::vector<Eigen::Vector3f> normal;    // walls: unit vector from the wall into the flow, zero elsewhere;
                                          // empty if unknown

  /// Further arrays by their name in the file, components interleaved; the number of components is the array's size
  /// divided by size().
  std::map<std::string, std::vector<float>> scalars;   // diagnostics
  std::map<std::string, std::vector<double>> doubles;  // state that a restart needs to the last bit

  /// Numbers about the whole set that a restart needs, by their name; FieldData of the file.
  std::map<std::string, std::vector<double>> facts;

  [[nodiscard]] std::size_t size() const { return id.size(); }
};

/// Number of particles of each ParticleType, indexed by its value.
std::array<std::int64_t, 4> count_by_type(const ParticleSet& particles);

/// Summed mass [kg] (2-D: [kg/m]) of each ParticleType, indexed by its value; in double.
std::array<double, 4> mass_by_type(const ParticleSet& particles);

}  // namespace thalweg
