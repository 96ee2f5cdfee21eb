// What the run gave: the upper half of the report.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "postproc/bed_change.hpp"
#include "postproc/figures.hpp"
#include "postproc/html.hpp"
#include "postproc/report_sections.hpp"

namespace thalweg::report_sections {
namespace {

using html::escape;

std::string millimetres(double metres) { return std::isnan(metres) ? "–" : fmt::format("{:.1f}", metres * 1e3); }
std::string signed_millimetres(double metres) {
  std::string text = fmt::format("{:+.1f}", metres * 1e3);
  if (text == "-0.0" || text == "+0.0") return "0.0";
  if (text.front() == '-') text.replace(0, 1, "\u2212");
  return text;
}
std::string percent(double share) { return std::isnan(share) ? "–" : fmt::format("{:.1f} %", share * 1e2); }

std::string duration(double seconds) {
  if (seconds < 120) return fmt::format("{:.1f} <span>s</span>", seconds);
  if (seconds < 7200) return fmt::format("{:.1f} <span>min</span>", seconds / 60);
  return fmt::format("{:.1f} <span>h</span>", seconds / 3600);
}

std::string tile(const std::string& value, const std::string& what) {
  return fmt::format("<div class=\"tile\"><div class=\"v\">{}</div><div class=\"k\">{}</div></div>\n", value, what);
}

std::string title_of(const std::string& curve_name) {
  for (const Curve& curve : curves) {
    if (curve.name == curve_name) return curve.title;
  }
  return curve_name;
}

std::optional<BedChange> change_of_bed(const ReportInput& input) {
  if (!input.extraction.initial || input.extraction.written.empty()) return std::nullopt;
  return bed_change(input.extraction.initial->profile, input.extraction.written.back().profile);
}

const Repeatability* scatter_of(const ReportInput& input, const std::string& curve, double time) {
  for (const Repeatability& known : input.repeatability) {
    if (known.curve == curve && std::abs(known.time - time) <= same_time) return &known;
  }
  return nullptr;
}

std::string what_is_seen(const ReportInput& input) {
  std::string text;
  const ExtractionRun& extraction = input.extraction;
  const FrontSample& last = extraction.fronts.back();
  if (!std::isnan(last.front)) {
    text += fmt::format("At t = {:g} s the water front stands at x = {:.3f} m. ", last.time, last.front);
  }
  const std::optional<BedChange> change = change_of_bed(input);
  if (change) {
    text += fmt::format(
        "By t = {:g} s the bed has been scoured by up to {} mm (at x = {:.3f} m) and raised by up to {} mm (at x = "
        "{:.3f} "
        "m). ",
        extraction.written.back().time, millimetres(change->scour), change->scour_at, millimetres(change->deposition),
        change->deposition_at);
  }
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

// The numbers of scalars.csv: front and extremes of the bed.
std::string extremes(const ReportInput& input) {
  std::vector<std::vector<std::string>> rows;
  std::string last_pair;
  for (const ScalarError& scalar : input.comparison.scalars) {
    if (!scalar.line.empty()) continue;
    const std::string pair = escape(scalar.compared) + " against " + escape(scalar.reference);
    if (pair != last_pair) rows.push_back({pair});
    last_pair = pair;
    std::string quantity = scalar.quantity;
    std::replace(quantity.begin(), quantity.end(), '_', ' ');
    const auto cell = [](double value) {
      return std::isnan(value) ? "–" : html::typeset(fmt::format("{:.4f}", value));
    };
    const double error = scalar.compared_value - scalar.reference_value;
    rows.push_back({quantity, fmt::format("{:g}", scalar.time), cell(scalar.compared_value),
                    cell(scalar.reference_value),
                    std::isnan(error) ? "–" : html::typeset(fmt::format("{:+.4f}", error))});
  }
  if (rows.empty()) return "";
  return "<h3>Front, deepest scour and highest deposition</h3>\n" +
         html::table({"quantity", "t [s]", "compared [m]", "against [m]", "difference [m]"}, rows, "lrrrr") +
         "<p class=\"small\">Numbers: <a href=\"scalars.csv\">report/scalars.csv</a>.</p>\n";
}

}  // namespace

std::string figure(const std::string& picture, const std::string& caption, const std::string& id) {
  const std::string shown =
      picture.empty()
          ? "<div class=\"missing\">no picture: gnuplot is not installed (apt-get install gnuplot-nox)</div>"
          : picture;
  const std::string named = id.empty() ? "" : " id=\"figure_" + id + "\"";
  return fmt::format("<figure{}>\n{}<figcaption>{}</figcaption>\n</figure>\n", named, shown, caption);
}

std::string id_of_profile(double time) {
  std::string name = profile_file_name(time);
  name.resize(name.rfind('.'));
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

std::string heading(const ReportInput& input) {
  const CaseInfo& info = input.resolved.info;
  std::string text = fmt::format("<header>\n<h1>{}</h1>\n", escape(info.title.empty() ? info.name : info.title));
  if (!info.source.empty()) text += fmt::format("<p class=\"source\">{}</p>\n", escape(info.source));
  text += fmt::format(
      "<p class=\"meta\">Case <b>{}</b> · {} · particle spacing <b>{:g} mm</b> · to t = <b>{:g} s</b> · Thalweg "
      "<b>{}</b> "
      "· case hash <b>{}</b></p>\n</header>\n",
      escape(info.name), info.dimension == 2 ? "2-D, the plane x–z, per metre of width" : "3-D",
      1e3 * input.extraction.info.spacing, input.extraction.last_time, escape(input.extraction.info.code_version),
      escape(input.extraction.info.case_hash));
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
    tiles += tile(fmt::format("{:.3f} <span>m</span>", last.front), fmt::format("water front at {:g} s", last.time));
  }
  if (const std::optional<BedChange> change = change_of_bed(input)) {
    tiles += tile(millimetres(change->scour) + " <span>mm</span>",
                  fmt::format("deepest scour at {:g} s", input.extraction.written.back().time));
  }
  return fmt::format("<section class=\"tiles\">\n{}</section>\n<p class=\"lead\">{}</p>\n", tiles, what_is_seen(input));
}

std::string profiles(const ReportInput& input, const std::filesystem::path& pictures) {
  std::string text = "<h2>Profiles</h2>\n<p class=\"key\">";
  constexpr const char* names[] = {"free surface", "bed", "moving bed (top of the sediment at rest)"};
  for (std::size_t c = 0; c < std::size(curves); ++c) {
    const bool there = std::any_of(input.sets.begin(), input.sets.end(), [c](const ProfileSet& set) {
      return std::any_of(set.profiles.begin(), set.profiles.end(),
                         [c](const TimedProfile& timed) { return !(timed.profile.*curves[c].values).empty(); });
    });
    if (!there) continue;
    text += fmt::format("<span class=\"swatch\" style=\"border-color:{}\"></span>{}", curve_colours[c], names[c]);
  }
  text += ". The colour says which curve it is; ";
  std::vector<std::string> kinds{"a full line is this SPH run"};
  const auto has = [&](SourceKind kind) {
    return std::any_of(input.sets.begin(), input.sets.end(), [&](const ProfileSet& set) { return set.kind == kind; });
  };
  if (has(SourceKind::mesh)) kinds.emplace_back("a dashed or dotted one a mesh model");
  if (has(SourceKind::other)) kinds.emplace_back("a dash-dotted one a further source");
  if (has(SourceKind::measured)) kinds.emplace_back("open markers are measured");
  const PictureFrame frame = frame_around(input.sets, input.resolved.compare.from, input.resolved.compare.to);
  text += fmt::format("{}. Heights are exaggerated {:.1f} times.</p>\n", fmt::join(kinds, ", "), frame.exaggeration());
  for (const TimedProfile& timed : input.extraction.written) {
    std::string name = profile_file_name(timed.time);
    name.resize(name.rfind('.'));
    const std::string id = id_of_profile(timed.time);
    const std::string picture =
        html::inline_svg(pictures / (name + ".svg"), id, fmt::format("Profiles at t = {:g} s", timed.time));
    text += figure(picture,
                   fmt::format("t = {:g} s. Numbers: <a href=\"../profiles/{}.csv\">profiles/{}.csv</a>; picture: "
                               "<a href=\"pictures/{}.png\">PNG</a>, <a href=\"pictures/{}.gp\">script</a>.",
                               timed.time, name, name, name, name),
                   id);
  }
  return text;
}

std::string errors(const ReportInput& input) {
  std::string text = "<h2>Differences between the sources</h2>\n";
  for (std::string note : input.reference_notes) {
    note.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(note.front())));
    text += "<p>" + escape(note) + ".</p>\n";
  }
  std::vector<CurveError> all = input.comparison.errors;
  std::erase_if(all, [](const CurveError& error) { return !error.line.empty(); });  // in errors.csv only
  if (all.empty()) return text + "<p>There was nothing to compare the run with.</p>\n";

  std::vector<double> times;
  for (const CurveError& error : all) {
    if (std::find(times.begin(), times.end(), error.time) == times.end()) times.push_back(error.time);
  }
  std::sort(times.begin(), times.end());
  std::vector<std::string> heads{"compared", "against", "curve"};
  for (const double time : times) heads.push_back(fmt::format("t = {:g} s", time));
  std::vector<std::vector<std::string>> rows;
  std::string last_row;
  bool any_within_scatter = false;
  for (const CurveError& error : all) {
    const std::string key = error.compared + "\n" + error.reference + "\n" + error.curve;
    if (key != last_row) {
      const bool same_pair = last_row.starts_with(error.compared + "\n" + error.reference + "\n");
      rows.push_back(
          {same_pair ? "" : escape(error.compared), same_pair ? "" : escape(error.reference), title_of(error.curve)});
      rows.back().resize(3 + times.size(), "–");
      last_row = key;
    }
    const auto column = static_cast<std::size_t>(std::find(times.begin(), times.end(), error.time) - times.begin());
    const Repeatability* scatter = scatter_of(input, error.curve, error.time);
    const bool within = scatter != nullptr && error.rmse <= scatter->rms;
    any_within_scatter = any_within_scatter || within;
    rows.back()[3 + column] = millimetres(error.rmse) + (within ? "*" : "");
  }
  for (const Curve& curve : curves) {
    std::vector<std::string> row{"<span class=\"soft\">scatter of equal runs</span>", "", curve.title};
    bool any = false;
    for (const double time : times) {
      const Repeatability* scatter = scatter_of(input, curve.name, time);
      any = any || scatter != nullptr;
      row.push_back(scatter != nullptr ? millimetres(scatter->rms) : "–");
    }
    if (any) rows.push_back(row);
  }
  text +=
      "<h3>Root mean square difference [mm]</h3>\n" + html::table(heads, rows, "lll" + std::string(times.size(), 'r'));
  if (!input.repeatability.empty()) {
    text += fmt::format(
        "<p class=\"small\">The scatter is what two runs differ by that differ in nothing of importance; smaller "
        "differences mean nothing{}. From the case's repeatability.csv: {}</p>\n",
        any_within_scatter ? " and are marked *" : "",
        escape(fmt::format("{}", fmt::join(input.repeatability_origin, " "))));
  }

  std::vector<std::vector<std::string>> full;
  last_row.clear();
  for (const CurveError& e : all) {
    const std::string pair = escape(e.compared) + " against " + escape(e.reference);
    if (pair != last_row) full.push_back({pair});
    last_row = pair;
    full.push_back({title_of(e.curve), fmt::format("{:g}", e.time), millimetres(e.rmse), percent(e.normalised_rmse),
                    signed_millimetres(e.bias), signed_millimetres(e.largest_error),
                    html::typeset(fmt::format("{:.3f}", e.largest_error_at)),
                    std::isnan(e.brier_skill) ? "–" : html::typeset(fmt::format("{:.2f}", e.brier_skill)),
                    fmt::format("{}", e.points),
                    html::typeset(fmt::format("{:.3f}", e.from)) + " … " + html::typeset(fmt::format("{:.3f}", e.to))});
  }
  text += "<h3>In full</h3>\n" + html::table({"curve", "t [s]", "RMSE [mm]", "of range", "bias [mm]", "largest [mm]",
                                              "at x [m]", "skill", "points", "common range [m]"},
                                             full, "lrrrrrrrrr", "long wide");
  text += fmt::format("<p class=\"small\">{}. Numbers: <a href=\"errors.csv\">report/errors.csv</a>.</p>\n",
                      escape(comparison_method));
  text += extremes(input);
  if (!input.comparison.remarks.empty()) {
    text += "<ul class=\"small\">\n";
    for (const std::string& remark : input.comparison.remarks) text += "<li>" + escape(remark) + "</li>\n";
    text += "</ul>\n";
  }
  return text;
}

std::string front_and_energies(const ReportInput& input, const std::filesystem::path& pictures) {
  const std::string width = input.resolved.info.dimension == 2 ? ", per metre of width" : "";
  std::string text = "<h2>Front and energies</h2>\n<div class=\"pair\">\n";
  text +=
      figure(html::inline_svg(pictures / "front.svg", "front", "Water front against time"),
             fmt::format("Water front: largest x with more than {:g} mm of water over the bed (half a spacing), all "
                         "sources measured alike. Numbers: <a href=\"../profiles/front.csv\">profiles/front.csv</a>, "
                         "<a href=\"fronts.csv\">report/fronts.csv</a>.",
                         1e3 * least_layer * input.extraction.info.spacing));
  if (input.history.rows > 0) {
    text +=
        figure(html::inline_svg(pictures / "energies.svg", "energies", "Energies against time"),
               fmt::format("Energies of water and sediment{}; potential and internal energy as change from the start. "
                           "The falling sum is what friction has taken. Numbers: <a "
                           "href=\"../history.csv\">history.csv</a>.",
                           width));
  }
  return text + "</div>\n";
}

std::string particles(const ReportInput& input, const std::filesystem::path& pictures) {
  const std::string picture = html::inline_png(pictures / "particles.png", "Particles at the last time");
  return "<h2>The particles</h2>\n" +
         figure(picture,
                fmt::format("The particles at t = {:g} s{}, heights not exaggerated: what they are, how fast they "
                            "are, and their pressure (sediment at rest keeps the one it stopped with). Open "
                            "<code>snapshots.pvd</code> in ParaView for all times.",
                            input.extraction.last_time,
                            input.resolved.info.dimension == 3
                                ? fmt::format(", in the plane y = {:g} m", input.extraction.plane_y)
                                : ""));
}

}  // namespace thalweg::report_sections
