// The depths of all methods side by side, and what follows where they differ.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "postproc/html.hpp"
#include "postproc/report_sections.hpp"
#include "postproc/report_sources.hpp"

namespace thalweg::report_sections {
namespace {

using html::escape;

/// A depth beside this run's.
struct Depth {
  std::string name;
  double value = 0;   // [m]
  double of_run = 0;  // [m] this run's, measured alike
  bool measured = false;
  bool is_formula = false;
  std::string remark;  // of a formula: its range
};

/// The scour that each other source has along the profile at the last time that both have.
std::vector<Depth> depths_of_sources(const ReportInput& input) {
  std::vector<Depth> depths;
  for (const ProfileSet& set : input.sets) {
    if (set.kind == SourceKind::run) continue;
    const ScalarError* last = nullptr;
    for (const ScalarError& error : input.comparison.scalars) {
      const bool of_pair = error.reference == set.label && error.compared == run_label && error.line.empty();
      if (!of_pair || error.quantity != "scour" || std::isnan(error.reference_value + error.compared_value)) continue;
      if (last == nullptr || error.time > last->time) last = &error;
    }
    if (last == nullptr) continue;
    depths.push_back({set.label, last->reference_value, last->compared_value, set.kind == SourceKind::measured, false,
                      fmt::format("along the profile at t = {:g} s", last->time)});
  }
  return depths;
}

void add_formulas(const ReportInput& input, std::vector<Depth>& depths) {
  for (const FormulaRow& row : input.formulas) {
    if (!is_depth(row)) continue;
    depths.push_back({row.formula + ", " + row.subject, *row.value, input.answer->depth, false, true,
                      row.outside.empty() ? "formula, within its range" : "formula, outside its range"});
  }
}

std::string verdict(const ReportInput& input, const Depth& depth) {
  if (depth.remark == "formula, outside its range") return "says little here";
  if (depth.is_formula && !input.scour.fit.has_reached()) return "of equilibrium, which the run has not reached";
  if (!input.band.is_known()) return "no band: open";
  if (std::abs(depth.of_run - depth.value) <= input.band.half_width()) return "within the band: the same";
  return depth.measured ? "the run misses the measurement" : "the methods differ";
}

}  // namespace

std::string conclusions(const ReportInput& input) {
  if (!input.answer) return "";
  std::vector<Depth> depths = depths_of_sources(input);
  add_formulas(input, depths);
  std::string text = "<h2>Depths of all methods, and what follows</h2>\n";
  if (depths.empty()) {
    return text +
           "<p>This depth stands alone: no mesh model, no measurement, and no formula for this scene. <code>thalweg "
           "foam</code> adds the first, <code>compare.references</code> the second.</p>\n";
  }
  const PageUnit& height = input.units.height;
  std::vector<std::vector<std::string>> rows;
  bool differ = false;
  for (const Depth& depth : depths) {
    const std::string follows = verdict(input, depth);
    differ = differ || follows == "the methods differ" || follows == "the run misses the measurement";
    rows.push_back({escape(depth.name), escape(depth.remark), height.number(depth.value), height.number(depth.of_run),
                    height.signed_number(depth.of_run - depth.value), follows});
  }
  text +=
      html::table({"method", "taken", fmt::format("scour [{}]", height.name), fmt::format("this run [{}]", height.name),
                   fmt::format("difference [{}]", height.name), "what follows"},
                  rows, "llrrrl", "wide");
  const std::string limit = input.band.is_known() ? "the band of " + band_in_words(input) : "a band";
  text += fmt::format(
      "<p>Differences within {} cannot be told from the effect of the numerical choices. A larger one comes from what "
      "the methods assume: particles let sediment yield and be carried as a body, a mesh with a bed-load law moves a "
      "thin layer by the stress on it, a formula holds the mean of experiments. A finer lattice does not remove it. "
      "{}</p>\n",
      limit,
      differ ? "Here some differ: take the deepest for a design, their distance as the uncertainty of the models, and "
               "look for a measurement of such a scene before less is taken."
             : "Here none is known to.");
  return text;
}

}  // namespace thalweg::report_sections
