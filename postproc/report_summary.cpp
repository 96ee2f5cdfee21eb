// The heading of the report, a paragraph with what is seen, and the tiles with the cost.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "postproc/bed_change.hpp"
#include "postproc/html.hpp"
#include "postproc/report_sections.hpp"

namespace thalweg::report_sections {
namespace {

using html::escape;

std::string tile(const std::string& value, const std::string& what) {
  return fmt::format("<div class=\"tile\"><div class=\"v\">{}</div><div class=\"k\">{}</div></div>\n", value, what);
}

std::string plane_of(const ReportInput& input) {
  return input.resolved.info.dimension == 2 ? "" : fmt::format(" in the plane y = {:g} m", input.extraction.plane_y);
}

// The change within the range of x that the case compares, along the profile; empty without such a range.
std::string change_in_range(const ReportInput& input) {
  const Compare& compare = input.resolved.compare;
  if (!input.extraction.initial || compare.from == compare.to) return "";  // equal: the whole domain
  const Profile& now = input.extraction.written.back().profile;
  const std::vector<double> rise = rise_of_bed(input.extraction.initial->profile, now);
  double scour = Profile::missing;
  double deposition = Profile::missing;
  for (std::size_t i = 0; i < rise.size(); ++i) {
    if (std::isnan(rise[i]) || now.x[i] < compare.from || now.x[i] > compare.to) continue;
    scour = std::fmax(scour, std::max(0.0, -rise[i]));
    deposition = std::fmax(deposition, std::max(0.0, rise[i]));
  }
  if (std::isnan(scour)) return "";
  const PageUnit& height = input.units.height;
  return fmt::format("In the region of interest{}, from x = {:g} m to {:g} m ([compare]), it is {} and {}. ",
                     plane_of(input), compare.from, compare.to, height.text(scour), height.text(deposition));
}

/// The change of a bed of particles in the end; that of a bed that is a surface stands in its own part.
std::string bed_in_words(const ReportInput& input) {
  if (input.series.of_bed_time || input.extraction.written.empty()) return "";
  const TimedProfile& last = input.extraction.written.back();
  const PageUnit& height = input.units.height;
  for (const BalanceSample& sample : input.extraction.balances) {
    if (std::abs(sample.time - last.time) > same_time || !sample.balance) continue;
    const BedBalance& change = *sample.balance;
    std::string text = fmt::format(
        "By t = {:g} s the bed has been scoured by up to {} (at {}) and raised by up to {} (at {}), looked for over "
        "the whole bed. {}",
        last.time, height.text(change.scour), place_in_words(input, change.scour_at.x(), change.scour_at.y()),
        height.text(change.deposition), place_in_words(input, change.deposition_at.x(), change.deposition_at.y()),
        change_in_range(input));
    if (std::isnan(change.resting_scour)) return text;
    return text + fmt::format("The sediment at rest (the moving bed's lower edge) has fallen by up to {} (at {}). ",
                              height.text(change.resting_scour),
                              place_in_words(input, change.resting_scour_at.x(), change.resting_scour_at.y()));
  }
  return "";
}

/// "free surface 5.8–7.0 mm, bed 7.4–7.8 mm": the distances of the run from another source over the times compared.
std::string distances_from(const ReportInput& input, const ProfileSet& set) {
  const PageUnit& height = input.units.height;
  std::string parts;
  for (const Curve& curve : curves) {
    double low = INFINITY;
    double high = 0;
    for (const CurveError& error : input.comparison.errors) {
      const bool of_pair = error.reference == set.label && error.compared == input.sets[0].label;
      if (!of_pair || !error.line.empty() || error.curve != curve.name) continue;
      low = std::min(low, error.rmse);
      high = std::max(high, error.rmse);
    }
    if (low > high) continue;
    const std::string range =
        height.number(low) == height.number(high) ? height.text(low) : height.number(low) + "–" + height.text(high);
    parts += fmt::format("{}{} {}", parts.empty() ? "" : ", ", curve.title, range);
  }
  return parts;
}

/// "on HOST, until 2026-11-27 23:58".
std::string computed_in_words(const ReportInput& input) {
  const Computed& computed = input.computed;
  return escape(fmt::format("{}, {}", computed.host.empty() ? "host not recorded" : "host " + computed.host,
                            computed.until.empty() ? "date not recorded" : computed.until));
}

}  // namespace

std::string place_in_words(const ReportInput& input, double x, double y) {
  const PageUnit& place = input.units.place;
  const std::string along = "x = " + place.text(x);
  return html::typeset(input.resolved.info.dimension == 2 ? along : along + ", y = " + place.text(y));
}

std::string heading(const ReportInput& input) {
  const CaseInfo& info = input.resolved.info;
  std::string text = fmt::format("<header>\n<h1>{}</h1>\n", escape(info.title.empty() ? info.name : info.title));
  if (!info.source.empty()) text += fmt::format("<p class=\"source\">{}</p>\n", escape(info.source));
  text += fmt::format(
      "<p class=\"meta\">Case <b>{}</b> · {} · particle spacing <b>{:g} mm</b> · to t = <b>{:g} s</b> · Thalweg "
      "<b>{}</b> · case hash <b>{}</b> · {}</p>\n{}</header>\n",
      escape(info.name), info.dimension == 2 ? "2-D, the plane x–z, per metre of width" : "3-D",
      1e3 * input.extraction.info.spacing, input.extraction.last_time, escape(input.extraction.info.code_version),
      escape(input.extraction.info.case_hash), computed_in_words(input),
      input.shortfall.empty() ? "" : "<p class=\"warnings\"><b>" + escape(input.shortfall) + "</b></p>\n");
  return text;
}

std::string what_is_seen(const ReportInput& input) {
  std::string text;
  const ExtractionRun& extraction = input.extraction;
  const FrontSample& last = extraction.fronts.back();
  if (!std::isnan(last.front) && !input.resolved.has_lasting_current()) {
    text += fmt::format(
        "At t = {:g} s the water front{} stands at x = {:.3f} m, where the water becomes less than {} deep (half a "
        "spacing). ",
        last.time, plane_of(input), last.front, input.units.height.text(least_layer * extraction.info.spacing));
  }
  text += bed_in_words(input);
  std::string distances;
  for (std::size_t s = 1; s < input.sets.size(); ++s) {
    const std::string parts = distances_from(input, input.sets[s]);
    if (parts.empty()) continue;
    const std::string from =
        input.sets[s].kind == SourceKind::measured ? "the measurement" : escape(input.sets[s].label);
    distances += fmt::format("{}from {}: {}", distances.empty() ? "" : "; ", from, parts);
  }
  if (!distances.empty()) text += "Root mean square distance, over the times compared, " + distances + ".";
  return text.empty() ? "" : "<p class=\"lead\">" + text + "</p>\n";
}

std::string cost(const ReportInput& input) {
  std::string tiles;
  if (const auto particles = number_of(input.summary, "particles")) {
    tiles += tile(html::grouped(*particles), "particles, walls included");
  }
  if (const auto steps = number_of(input.summary, "steps")) tiles += tile(html::grouped(*steps), "time steps");
  const PageUnit& unit = input.units.cost;
  const auto time = [&](const char* quantity, const char* what) {
    if (const auto value = number_of(input.summary, quantity)) {
      tiles += tile(fmt::format("{} <span>{}</span>", unit.number(*value), unit.name), what);
    }
  };
  time("wall_seconds", "wall-clock time");
  time("cpu_seconds", "processor time");
  if (const auto rate = number_of(input.summary, "particle_steps_per_second")) {
    tiles += tile(fmt::format("{:.2f} <span>M/s</span>", *rate / 1e6), "particle-steps per second");
  }
  if (tiles.empty()) return "<h2>What it cost</h2>\n<p>summary.csv is missing: the run has not come to its end.</p>\n";
  return fmt::format(
      "<h2>What it cost</h2>\n<section class=\"tiles\">\n{}</section>\n<p class=\"small\">Computed on {}, {}.</p>\n",
      tiles, escape(text_of(input.summary, "device").value_or("an unknown device")), computed_in_words(input));
}

}  // namespace thalweg::report_sections
