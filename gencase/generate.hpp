#pragma once

#include <array>
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
};

/// Fills the scene with particles at hydrostatic rest. Says their number and memory before it allocates them. Throws
/// InputError naming shape, line, cause and cure: shapes without particles, fluid outside of the domain or the
/// containers, more memory than `memory_limit`, geometry that place_shapes refuses.
Generated generate(const Case& scene, const GenerateOptions& options = {});

}  // namespace thalweg::gencase
