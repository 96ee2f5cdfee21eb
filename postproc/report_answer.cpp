// The answer at the top of the page: deepest scour with place, time, definition and band; or the water's numbers.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "case/models/surface_bed.hpp"
#include "postproc/html.hpp"
#include "postproc/report_sections.hpp"

namespace thalweg::report_sections {
namespace {

using html::escape;

std::string time_in_words(const ReportInput& input, const ScourAnswer& answer) {
  const std::string water = fmt::format("t = {:.4g} s", answer.time);
  if (std::isnan(answer.bed_time)) return water;
  return fmt::format("{} of the bed’s time (the water’s {})", input.units.bed_time.text(answer.bed_time), water);
}

std::string definition(const ReportInput& input) {
  if (!std::isnan(input.answer->bed_time)) {
    return "largest fall of a column of the bed since the start";
  }
  return fmt::format(
      "largest fall of the bed since the start, anywhere; the bed is the top of the sediment, moving or not{}",
      has_water(input.resolved) ? "" : ", and the bare floor where it has left");
}

std::string band(const ReportInput& input) {
  const ScourBand& band = input.band;
  const PageUnit& height = input.units.height;
  if (!band.is_known()) {
    return input.series.of_bed_time
               ? "none was computed: <code>--set compare.factor_runs=2</code> runs the case again with half the "
                 "factor, <code>compare.runs=2</code> with twice the spacing, and this page then gives one"
               : "none was computed: <code>--set compare.runs=2</code> runs the case again with twice the spacing, and "
                 "this page then gives one";
  }
  std::vector<std::string> parts;
  for (const ScourBeside& run : band.beside) {
    parts.push_back(
        fmt::format("{} against {} with {}", height.number(run.of_main), height.text(run.depth), escape(run.label)));
  }
  if (!std::isnan(band.scatter)) parts.push_back(fmt::format("equal runs scatter by {}", height.text(band.scatter)));
  if (!band.spacing_varied) parts.emplace_back("the spacing was not varied (<code>compare.runs=2</code> does)");
  return fmt::format("{}: {}. This is the effect of the numerical choices on the depth, and no error against nature",
                     band_in_words(input), fmt::join(parts, "; "));
}

using Facts = std::vector<std::pair<std::string, std::string>>;

std::string box(const std::string& value, const std::string& unit, const std::string& what, const Facts& facts) {
  std::string text = fmt::format(
      "<section class=\"answer\">\n<div class=\"big\"><div class=\"v\">{} <span>{}</span></div><div "
      "class=\"k\">{}</div></div>\n<dl>\n",
      value, unit, what);
  for (const auto& [name, fact] : facts) text += fmt::format("<dt>{}</dt><dd>{}</dd>\n", name, fact);
  return text + "</dl>\n</section>\n";
}

std::string of_bed(const ReportInput& input) {
  const ScourAnswer& answer = *input.answer;
  const PageUnit& height = input.units.height;
  const PageUnit& volume = input.units.volume;
  Facts facts;
  if (height.number(answer.depth) == height.number(0)) {
    const bool spinning = models::SurfaceBedOfCase::is_on(input.resolved) && input.scour.time.empty();
    facts.emplace_back("where", spinning ? "nowhere: the bed has taken no step yet (<code>surface_bed.spin_up</code>)"
                                         : "nowhere: the bed has not fallen");
  } else {
    facts = {{"where", place_in_words(input, answer.x, answer.y)}, {"when", time_in_words(input, answer)}};
  }
  const double slight = 0.05 * input.extraction.info.spacing;
  if (answer.depth - answer.at_end > slight) facts.emplace_back("in the end", height.text(answer.at_end));
  if (!input.series.time.empty()) {
    facts.emplace_back("highest rise", height.text(input.series.deposition.back()) + " in the end");
    facts.emplace_back(
        "volume", html::typeset(fmt::format("{} fallen, {} risen in the end{}", volume.text(input.series.eroded.back()),
                                            volume.text(input.series.deposited.back()),
                                            input.resolved.info.dimension == 2 ? ", per metre of width" : "")));
  }
  facts.emplace_back("definition", definition(input));
  facts.emplace_back("band", band(input));
  return box(height.number(answer.depth), height.name,
             fmt::format("{}{}", has_water(input.resolved) ? "deepest scour" : "deepest fall of the bed",
                         input.shortfall.empty() ? "" : " so far"),
             facts);
}

/// True if the water's front is an event: it moves, and no current lasts.
bool has_moving_front(const ReportInput& input) {
  double low = INFINITY;
  double high = -INFINITY;
  for (const FrontSample& sample : input.extraction.fronts) {
    low = std::fmin(low, sample.front);
    high = std::fmax(high, sample.front);
  }
  return !std::isnan(input.extraction.fronts.back().front) && high - low > 2 * input.extraction.info.spacing &&
         !input.resolved.has_lasting_current();
}

std::string without_bed(const ReportInput& input) {
  Facts facts;
  const FrontSample& last = input.extraction.fronts.back();
  const std::string plane =
      input.resolved.info.dimension == 2 ? "" : fmt::format(" in the plane y = {:g} m", input.extraction.plane_y);
  if (input.history.max_speed > 0)
    facts.emplace_back("largest speed", fmt::format("{:.3g} m/s", input.history.max_speed));
  for (const OpeningRecord& opening : input.openings.openings) {
    const double sign = opening.enters ? 1 : -1;
    facts.emplace_back(
        escape(opening.name),
        html::typeset(fmt::format(
            "{:.4g} {} {}{}", sign * opening.mean_rate, input.resolved.info.dimension == 2 ? "m^2/s" : "m^3/s",
            opening.enters ? "in" : "out",
            std::isnan(opening.mean_level) ? "" : ", level " + input.units.height.text(opening.mean_level))));
  }
  facts.emplace_back("scour", input.resolved.has_sediment() ? "no bed: the grains are in the water"
                                                            : "no question of this case: it has no sediment");
  if (!has_moving_front(input)) {
    if (!(input.history.max_speed > 0)) return box("–", "", "no speed recorded", facts);
    facts.erase(facts.begin());
    return box(fmt::format("{:.3g}", input.history.max_speed), "m/s", "largest speed", facts);
  }
  return box(fmt::format("{:.3f}", last.front), "m", fmt::format("water front at t = {:g} s{}", last.time, plane),
             facts);
}

}  // namespace

std::string band_in_words(const ReportInput& input) {
  return "± " + input.units.height.text_or_less(input.band.half_width());
}

std::string answer(const ReportInput& input) { return input.answer ? of_bed(input) : without_bed(input); }

}  // namespace thalweg::report_sections
