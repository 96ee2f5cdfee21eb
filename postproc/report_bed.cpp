// The bed in the end: seen from above, cut through its deepest place, and the shear stress on it.
#include <fmt/format.h>

#include <algorithm>

#include "postproc/figures/bed_figures.hpp"
#include "postproc/figures/tic_step.hpp"
#include "postproc/html.hpp"
#include "postproc/report_sections.hpp"

namespace thalweg::report_sections {
namespace {

std::string missing_stress(const ReportInput& input) {
  if (!has_water(input.resolved)) return "";
  return fmt::format(
      "<h2>Shear stress on the bed</h2>\n<p>The snapshots of this run carry none: with <code>model.sediment = "
      "\"{}\"</code> "
      "the sediment yields by its own stresses, and no stress of the water on a surface is computed. "
      "<code>\"three-state\"</code> and <code>\"surface\"</code> compute one.</p>\n",
      word_for(input.resolved.model.sediment));
}

}  // namespace

std::string bed_map(const ReportInput& input, const std::filesystem::path& pictures) {
  const BedMap& map = input.map.map;
  if (map.size() == 0 || map.ny == 1) return "";
  const BedExtremes extremes = extremes_of(map);
  const double largest = std::max(extremes.scour, extremes.deposition);
  const double stretch = map_stretch(map);
  constexpr double visible = 1.05;
  const PageUnit& height = input.units.height;
  return "<h2>The bed from above</h2>\n" +
         figure(
             html::inline_png(pictures / "bed_map.png", "Change of the bed seen from above"),
             fmt::format("Change of the bed’s level from the start to t = {:g} s: blue-green where it has sunk, brown "
                         "where it has risen, white where it has not changed; a line every {}{}. The cross marks the "
                         "deepest place, {} at {}. Dark grey: bodies in the flow; light grey: "
                         "walls around it.{} Numbers: <a href=\"data/bed_map.csv\">data/bed_map.csv</a>.",
                         map.time,
                         fmt::format("{:g}\u00a0{}", tic_step(std::max(largest, 1e-9), most_contours) / height.size,
                                     height.name),
                         map.in_columns ? " (columns of the bed)" : "", height.text(extremes.scour),
                         place_in_words(input, map.x(extremes.scour_at[0]), map.y(extremes.scour_at[1])),
                         stretch > visible ? fmt::format(" The width is stretched {:.1f} times.", stretch) : ""));
}

std::string sections(const ReportInput& input, const std::filesystem::path& pictures) {
  const BedMap& map = input.map.map;
  if (map.size() == 0) return "";
  const BedExtremes extremes = extremes_of(map);
  const bool in_space = map.ny > 1;
  const std::string where = place_in_words(input, map.x(extremes.scour_at[0]), map.y(extremes.scour_at[1]));
  std::string text =
      fmt::format("<h2>{}</h2>\n", in_space ? "Sections through the deepest place" : "The bed before and after");
  const std::string caption = fmt::format(
      "Bed at the start (dashed) and at t = {:g} s; the arrow is the fall at {}: {}. Heights are exaggerated. ",
      map.time, where, input.units.height.text(extremes.scour));
  text += figure(html::inline_svg(pictures / "section_x.svg", "section_x", "Section along x through the deepest place"),
                 caption + "Numbers: <a href=\"data/section_x.csv\">data/section_x.csv</a>.");
  if (in_space) {
    text +=
        figure(html::inline_svg(pictures / "section_y.svg", "section_y", "Section along y through the deepest place"),
               "The same across the flow. Numbers: <a href=\"data/section_y.csv\">data/section_y.csv</a>.");
  }
  return text;
}

std::string bed_shear(const ReportInput& input, const std::filesystem::path& pictures) {
  const RunBedMap& run = input.map;
  if (run.map.size() == 0) return "";
  if (run.map.shields.empty()) return missing_stress(input);
  const bool in_space = run.map.ny > 1;
  const std::string origin = run.map.in_columns ? "Mean shear stress of the water on each column in the last window"
                                                : "From the Shields numbers of the grains at the bed’s surface";
  const std::string picture =
      in_space ? html::inline_png(pictures / "shear_map.png", "Shear stress on the bed seen from above")
               : html::inline_svg(pictures / "shear.svg", "shear", "Shear stress along the bed");
  const std::string critical =
      run.critical_stress > 0
          ? fmt::format(
                " {}: {:.3g} Pa, a Shields number of {:.3g}, at which a flat bed of these grains begins to move.",
                in_space ? "Orange line" : "Dashed", run.critical_stress, run.critical_stress / run.grain_weight)
          : "";
  return "<h2>Shear stress on the bed</h2>\n" +
         figure(picture,
                fmt::format(
                    "{}, at t = {:g} s. Shields number = stress / {:.3g} Pa, (ρ<sub>s</sub> − ρ) g d.{} Numbers: <a "
                    "href=\"data/bed_map.csv\">data/bed_map.csv</a>.",
                    origin, run.map.time, run.grain_weight, critical));
}

}  // namespace thalweg::report_sections
