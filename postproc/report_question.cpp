// The question of a run and its scene, in sentences.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "case/models/surface_bed.hpp"
#include "common/units.hpp"
#include "postproc/html.hpp"
#include "postproc/report_sections.hpp"

namespace thalweg::report_sections {
namespace {

bool has_shape(const Case& of, ShapeRole role) {
  return std::any_of(of.shapes.begin(), of.shapes.end(), [role](const Shape& shape) { return shape.role == role; });
}

/// "a and b", "a, b and c"; more than four are counted.
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 4;
  if (names.size() > most)
    return fmt::format("{} and {} more", fmt::join(names.begin(), names.begin() + most, ", "), names.size() - most);
  if (names.size() < 2) return names.empty() ? "" : names.front();
  return fmt::format("{} and {}", fmt::join(names.begin(), names.end() - 1, ", "), names.back());
}

std::string grains_in_words(const Case& of) {
  std::vector<std::string> names;
  for (const auto& [name, sediment] : of.sediments) {
    names.push_back(fmt::format("{} (grains of {}, {})", name, format_quantity(sediment.grain_diameter, "m"),
                                format_quantity(sediment.grain_density, "kg/m^3")));
  }
  return listed(names);
}

std::string bodies_in_words(const Case& of) {
  std::vector<std::string> fixed;
  std::vector<std::string> moving;
  for (const Shape& shape : of.shapes) {
    if (shape.side == WallSide::outside) continue;  // the container
    if (shape.role == ShapeRole::wall) fixed.push_back(shape.name);
    if (shape.role == ShapeRole::moving_wall) moving.push_back(shape.name);
  }
  std::string text;
  if (!fixed.empty()) text += "; walls: " + listed(fixed);
  if (!moving.empty()) text += "; moving: " + listed(moving);
  return text;
}

std::string drive_in_words(const Case& of) {
  switch (of.flow.drive) {
    case Drive::slope:
      return fmt::format("; driven as down a slope of {:g}", of.flow.slope);
    case Drive::discharge:
      return "; driven at a discharge of " + format_quantity(of.flow.discharge, "m^2/s");
    case Drive::velocity:
      return "; driven at a mean velocity of " + format_quantity(of.flow.velocity, "m/s");
    case Drive::off:
      break;
  }
  std::vector<std::string> names;
  for (const Inlet& inlet : of.inlets) names.push_back(inlet.name);
  std::string text = names.empty() ? "" : "; water comes in at " + listed(names);
  names.clear();
  for (const Outlet& outlet : of.outlets) names.push_back(outlet.name);
  return text + (names.empty() ? "" : "; it leaves at " + listed(names));
}

}  // namespace

bool has_water(const Case& of) { return has_shape(of, ShapeRole::water) || !of.inlets.empty(); }

std::string question(const ReportInput& input) {
  const Case& of = input.resolved;
  const bool bed = input.answer.has_value();
  std::string asked = "How does the water move?";
  if (bed && has_water(of)) asked = "How deep does the water scour the bed, where and when?";
  if (bed && !has_water(of)) asked = "How far does the dry bed fall and spread?";
  if (!bed && of.has_sediment()) asked = "How do the grains move with the water?";
  std::string scene = of.info.dimension == 2 ? "A plane x–z, per metre of width: " : "A scene in space: ";
  if (has_water(of)) scene += "water";
  if (of.has_sediment()) scene += (has_water(of) ? " over " : "") + grains_in_words(of);
  scene += bodies_in_words(of) + drive_in_words(of);
  scene += fmt::format("; computed to t = {:g} s", input.extraction.last_time);
  if (!input.scour.time.empty()) {
    scene += ", which stands for " + input.units.bed_time.text(input.scour.time.back()) + " of the bed’s time";
  }
  return fmt::format("<p class=\"asked\"><b>{}</b> {}.</p>\n", asked, html::typeset(scene));
}

}  // namespace thalweg::report_sections
