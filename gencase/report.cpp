#include "gencase/report.hpp"

#include <fmt/format.h>

#include <array>

#include "common/units.hpp"
#include "gencase/places.hpp"

namespace thalweg::gencase {
namespace {

constexpr std::array type_names{"wall", "moving wall", "water", "sediment"};

std::string shape_lines(const Generated& generated) {
  const char* unit = generated.resolved.info.dimension == 2 ? "m^2" : "m^3";
  std::string text;
  for (const ShapeSummary& shape : generated.summary.shapes) {
    text += fmt::format("  {:<16} {:>10} particles", shape.name, shape.particles);
    if (shape.filled > 0 && shape.exact > 0)
      text += fmt::format("  filled {:.6g} {} of {:.6g} ({:+.2f} %)", shape.filled, unit, shape.exact,
                          100 * (shape.filled / shape.exact - 1));
    else if (shape.filled > 0)
      text += fmt::format("  filled {:.6g} {}", shape.filled, unit);
    text += '\n';
  }
  return text;
}

std::string type_lines(const Generated& generated) {
  const char* unit = generated.resolved.info.dimension == 2 ? "kg/m" : "kg";
  const auto& counts = generated.summary.counts;
  const auto& masses = generated.summary.masses;
  std::string text;
  for (std::size_t type = 0; type < type_names.size(); ++type) {
    if (counts[type] == 0) continue;
    text += fmt::format("  {:<16} {:>10} particles", type_names[type], counts[type]);
    const bool is_fluid = type >= static_cast<std::size_t>(ParticleType::water);
    text += is_fluid ? fmt::format("  {:.6g} {}\n", masses[type], unit) : "\n";
  }
  return text;
}

std::string bounds_line(const Generated& generated) {
  const Vec3 lower = generated.summary.bounds.min();
  const Vec3 upper = generated.summary.bounds.max();
  const double spacing = generated.resolved.numerics.spacing;
  std::string text = "bounds:";
  for (int axis = 0; axis < 3; ++axis) {
    if (generated.resolved.info.dimension == 2 && axis == 1) continue;
    text += fmt::format(" {} {} … {} m", "xyz"[axis], placed_number(lower[axis], spacing),
                        placed_number(upper[axis], spacing));
  }
  return text + '\n';
}

}  // namespace

std::string report(const Generated& generated) {
  const Summary& summary = generated.summary;
  return fmt::format(
      "shapes (spacing {}):\n{}types:\n{}{}fluid height {}, sound speed {:.4g} m/s, largest hydrostatic "
      "pressure {}\n",
      format_quantity(generated.resolved.numerics.spacing, "m"), shape_lines(generated), type_lines(generated),
      bounds_line(generated), format_quantity(summary.fluid_height, "m"), summary.sound_speed,
      format_quantity(summary.largest_pressure, "Pa"));
}

}  // namespace thalweg::gencase
