// The beginning of the report: its heading, the tiles with the main numbers and a sentence or two.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "postproc/bed_change.hpp"
#include "postproc/html.hpp"
#include "postproc/report_sections.hpp"

namespace thalweg::report_sections {
namespace {

using html::escape;

std::string millimetres(double metres) { return std::isnan(metres) ? "–" : fmt::format("{:.1f}", metres * 1e3); }
std::string duration(double seconds) {
  if (seconds < 120) return fmt::format("{:.1f} <span>s</span>", seconds);
  if (seconds < 7200) return fmt::format("{:.1f} <span>min</span>", seconds / 60);
  return fmt::format("{:.1f} <span>h</span>", seconds / 3600);
}

std::string tile(const std::string& value, const std::string& what) {
  return fmt::format("<div class=\"tile\"><div class=\"v\">{}</div><div class=\"k\">{}</div></div>\n", value, what);
}

// The change of the whole bed up to the last time with a profile.
std::optional<BedBalance> change_of_bed(const ReportInput& input) {
  if (input.extraction.written.empty()) return std::nullopt;
  for (const BalanceSample& sample : input.extraction.balances) {
    if (std::abs(sample.time - input.extraction.written.back().time) <= same_time) return sample.balance;
  }
  return std::nullopt;
}

std::string place(const ReportInput& input, const Vec3& at) {
  return input.resolved.info.dimension == 2 ? fmt::format("x = {:.3f} m", at.x())
                                            : fmt::format("x = {:.3f} m, y = {:.3f} m", at.x(), at.y());
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
  return fmt::format("In the region of interest{}, from x = {:g} m to {:g} m ([compare]), it is {} mm and {} mm. ",
                     plane_of(input), compare.from, compare.to, millimetres(scour), millimetres(deposition));
}

std::string bed_in_words(const ReportInput& input, const BedBalance& change) {
  std::string text = fmt::format(
      "By t = {:g} s the bed has been scoured by up to {} mm (at {}) and raised by up to {} mm (at {}), looked for "
      "over "
      "the whole bed. {}",
      input.extraction.written.back().time, millimetres(change.scour), place(input, change.scour_at),
      millimetres(change.deposition), place(input, change.deposition_at), change_in_range(input));
  text += "Scour depth is the fall of the bed, the top of the sediment whether it moves or not, since the start. ";
  if (!std::isnan(change.resting_scour)) {
    text += fmt::format("The sediment at rest (the moving bed's lower edge) has fallen by up to {} mm (at {}). ",
                        millimetres(change.resting_scour), place(input, change.resting_scour_at));
  }
  return text;
}

std::string what_is_seen(const ReportInput& input) {
  std::string text;
  const ExtractionRun& extraction = input.extraction;
  const FrontSample& last = extraction.fronts.back();
  if (!std::isnan(last.front)) {
    text += fmt::format(
        "At t = {:g} s the water front{} stands at x = {:.3f} m, where the water becomes less than {:g} "
        "mm deep (half a spacing). ",
        last.time, plane_of(input), last.front, 1e3 * least_layer * extraction.info.spacing);
  }
  if (const std::optional<BedBalance> change = change_of_bed(input)) text += bed_in_words(input, *change);
  std::string distances;
  for (std::size_t s = 1; s < input.sets.size(); ++s) {
    std::string parts;
    for (const Curve& curve : curves) {
      double low = INFINITY;
      double high = 0;
      for (const CurveError& error : input.comparison.errors) {
        const bool of_pair = error.reference == input.sets[s].label && error.compared == input.sets[0].label;
        if (!of_pair || !error.line.empty() || error.curve != curve.name) continue;
        low = std::min(low, error.rmse);
        high = std::max(high, error.rmse);
      }
      if (low > high) continue;
      const std::string range =
          millimetres(low) == millimetres(high) ? millimetres(low) : millimetres(low) + "–" + millimetres(high);
      parts += fmt::format("{}{} {} mm", parts.empty() ? "" : ", ", curve.title, range);
    }
    if (parts.empty()) continue;
    const std::string from =
        input.sets[s].kind == SourceKind::measured ? "the measurement" : escape(input.sets[s].label);
    distances += fmt::format("{}from {}: {}", distances.empty() ? "" : "; ", from, parts);
  }
  if (!distances.empty()) text += "Root mean square distance, over the times compared, " + distances + ".";
  return text;
}

}  // namespace

std::string heading(const ReportInput& input) {
  const CaseInfo& info = input.resolved.info;
  std::string text = fmt::format("<header>\n<h1>{}</h1>\n", escape(info.title.empty() ? info.name : info.title));
  if (!info.source.empty()) text += fmt::format("<p class=\"source\">{}</p>\n", escape(info.source));
  text += fmt::format(
      "<p class=\"meta\">Case <b>{}</b> · {} · particle spacing <b>{:g} mm</b> · to t = <b>{:g} s</b> · Thalweg "
      "<b>{}</b> "
      "· case hash <b>{}</b></p>\n{}</header>\n",
      escape(info.name), info.dimension == 2 ? "2-D, the plane x–z, per metre of width" : "3-D",
      1e3 * input.extraction.info.spacing, input.extraction.last_time, escape(input.extraction.info.code_version),
      escape(input.extraction.info.case_hash),
      input.shortfall.empty() ? "" : "<p class=\"warnings\"><b>" + escape(input.shortfall) + "</b></p>\n");
  return text;
}

std::string at_a_glance(const ReportInput& input) {
  std::string tiles;
  if (const auto particles = number_of(input.summary, "particles")) {
    tiles += tile(html::grouped(*particles), "particles, walls included");
  }
  if (const auto steps = number_of(input.summary, "steps")) tiles += tile(html::grouped(*steps), "time steps");
  if (const auto wall = number_of(input.summary, "wall_seconds")) tiles += tile(duration(*wall), "wall-clock time");
  if (const auto rate = number_of(input.summary, "particle_steps_per_second")) {
    tiles += tile(fmt::format("{:.2f} <span>M/s</span>", *rate / 1e6), "particle-steps per second");
  }
  const FrontSample& last = input.extraction.fronts.back();
  if (!std::isnan(last.front)) {
    tiles += tile(fmt::format("{:.3f} <span>m</span>", last.front),
                  fmt::format("water front at {:g} s{}", last.time, plane_of(input)));
  }
  if (const std::optional<BedBalance> change = change_of_bed(input)) {
    tiles += tile(millimetres(change->scour) + " <span>mm</span>",
                  fmt::format("deepest scour of the whole bed at {:g} s, {}", input.extraction.written.back().time,
                              place(input, change->scour_at)));
  }
  return fmt::format("<section class=\"tiles\">\n{}</section>\n<p class=\"lead\">{}</p>\n", tiles, what_is_seen(input));
}

}  // namespace thalweg::report_sections
