#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "common/memory.hpp"
#include "common/particles.hpp"
#include "gencase/notes.hpp"
#include "gencase/progress.hpp"

namespace thalweg::gencase {

/// Particles and volume of one shape. The volumes are 0 for shapes that are not fluid.
struct ShapeSummary {
  std::string name;
  std::int64_t particles = 0;
  double filled = 0;  // [m^3] (2-D: [m^2]) of the particles that it has in the end
  double exact = 0;   // [m^3] ([m^2]) of the shape; 0: no closed form
};

/// Figures of a generated scene, for the report on stdout.
struct Summary {
  std::vector<ShapeSummary> shapes;
  double fluid_height = 0;      // [m]
  double sound_speed = 0;       // [m/s]
  double largest_pressure = 0;  // [Pa]
  std::int64_t lattice_nodes = 0;
  std::array<std::int64_t, 4> counts{};  // of particles, by ParticleType
  std::array<double, 4> masses{};        // [kg] (2-D: [kg/m])
  Eigen::AlignedBox3d bounds;            // [m]

  /// Adds particles to these three.
  void count(const ParticleSet& range);
};

/// A scene at t = 0.
struct Generated {
  Case resolved;  // with the maximum speed that the sound speed follows from
  ParticleSet particles;
  Summary summary;
};

struct GenerateOptions {
  double memory_limit = available_memory();  // [bytes]
  Notes notes;
  bool progress = false;  // shows on a terminal how far a long filling is
  /// True: the run may need more memory than there is here, because several machines compute it; gencase alone has to find room.
  bool larger_than_memory = false;
  std::int64_t nodes_at_once = std::int64_t{1} << 19;  // of the lattice, whose particles are in memory together
};

/// Fills the scene with particles at hydrostatic rest. Says their number and memory before it allocates them. Throws
/// InputError naming shape, line, cause and cure: shapes without particles, fluid outside of the domain or the
/// containers, more memory than `memory_limit`, geometry that place_shapes refuses.
Generated generate(const Case& scene, const GenerateOptions& options = {});

/// The same for a scene whose particles need not be in memory together: they are given to `take` range by range, in the order
/// of their ids. The result has no particles, but their facts. A scene whose particles are moved beside walls
/// (gencase.relaxation), or whose bed is split into grains and water (model.seepage), comes as one range.
Generated generate_in_ranges(const Case& scene, const GenerateOptions& options,
                             const std::function<void(ParticleSet)>& take);

}  // namespace thalweg::gencase
