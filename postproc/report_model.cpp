// The lower half of the report: the run, its model and the sources of the page.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/units.hpp"
#include "common/version.hpp"
#include "postproc/constants.hpp"
#include "postproc/html.hpp"
#include "postproc/report_sections.hpp"

namespace thalweg::report_sections {
namespace {

using html::escape;

// "1234567.8" → "1 234 568"; texts and small numbers stay as they are.
std::string readable(const std::string& value) {
  const std::optional<double> number = number_of({{"", value, ""}}, "");
  if (!number) return escape(value);
  if (std::abs(*number) >= 1e4 && std::abs(*number) < 1e15) return html::grouped(*number);
  return html::typeset(fmt::format("{:.5g}", *number));
}

std::string spaced(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return escape(name);
}

std::string quantity_table(const std::vector<Quantity>& quantities) {
  std::vector<std::vector<std::string>> rows;
  for (const Quantity& quantity : quantities) {
    rows.push_back({spaced(quantity.name), readable(quantity.value),
                    quantity.unit == "-" ? std::string() : html::typeset(quantity.unit)});
  }
  return html::table({}, rows, "lrl");
}

// One column per mesh model, one row for every quantity any of them has.
std::string mesh_table(const std::vector<MeshModel>& meshes) {
  std::vector<std::string> heads{""};
  std::vector<Quantity> named;
  for (const MeshModel& mesh : meshes) {
    heads.push_back(escape(mesh.label));
    for (const Quantity& quantity : mesh.summary) {
      if (!text_of(named, quantity.name)) named.push_back(quantity);
    }
  }
  heads.emplace_back("");
  std::vector<std::vector<std::string>> rows;
  for (const Quantity& quantity : named) {
    std::vector<std::string> row{spaced(quantity.name)};
    for (const MeshModel& mesh : meshes) row.push_back(readable(text_of(mesh.summary, quantity.name).value_or("–")));
    row.push_back(quantity.unit == "-" ? std::string() : html::typeset(quantity.unit));
    rows.push_back(std::move(row));
  }
  return html::table(heads, rows, "l" + std::string(meshes.size(), 'r') + "l", "texts");
}

std::string bar(double share) {
  return fmt::format("<span class=\"bar\" style=\"width:{:.1f}px\"></span>", 160 * std::clamp(share, 0.0, 1.0));
}

std::string limiter_table(const History& history) {
  std::vector<std::vector<std::string>> rows;
  for (const History::Share& entry : history.limiters) {
    rows.push_back({escape(entry.limiter), fmt::format("{:.1f} %", 100 * entry.share), bar(entry.share)});
  }
  return html::table({"limited by", "share", ""}, rows, "lrl");
}

std::string timing_table(const std::vector<Timing>& timing) {
  std::vector<std::vector<std::string>> rows;
  for (const Timing& entry : timing) {
    rows.push_back({escape(entry.heading), fmt::format("{:.2f}", entry.seconds),
                    fmt::format("{:.1f} %", 100 * entry.share), bar(entry.share), html::grouped(entry.calls)});
  }
  return html::table({"heading", "seconds", "share", "", "calls"}, rows, "lrrlr");
}

std::string mass_change(const char* phase, const std::vector<double>& mass) {
  if (mass.empty() || mass.front() == 0) return "";
  const double change = mass.back() / mass.front() - 1;
  return fmt::format(" {} {}", phase,
                     change == 0 ? "unchanged" : html::typeset(fmt::format("{:+.1g} of itself", change)));
}

/// Of a scene that is closed: with openings the mass changes as it should.
std::string mass_sentence(const ReportInput& input) {
  if (!input.openings.openings.empty()) return "";
  const History& history = input.history;
  const std::string water = mass_change("water", history.water_mass);
  const std::string sediment = mass_change("sediment", history.sediment_mass);
  if (water.empty() && sediment.empty()) return "";
  return fmt::format("<p class=\"small\">Mass over the run:{}{}{}.</p>\n", water,
                     !water.empty() && !sediment.empty() ? "," : "", sediment);
}

}  // namespace

std::string run_numbers(const ReportInput& input) {
  std::string text = "<h2>How the runs went</h2>\n<div class=\"pair\">\n<div>\n<h3>This run</h3>\n";
  text += input.summary.empty() ? "<p>summary.csv is missing.</p>\n" : quantity_table(input.summary);
  text += "</div>\n<div>\n";
  if (!input.timing.empty()) text += "<h3>Where the time went</h3>\n" + timing_table(input.timing);
  if (!input.history.limiters.empty()) {
    const auto [least, most] = std::minmax_element(input.history.dt.begin(), input.history.dt.end());
    text += "<h3>What limited the time step</h3>\n" + limiter_table(input.history);
    text += fmt::format(
        "<p class=\"small\">Share of the {} rows of <a href=\"../history.csv\">history.csv</a>; the step lay "
        "between {} and {}.</p>\n",
        input.history.rows, html::typeset(format_quantity(*least, "s")), html::typeset(format_quantity(*most, "s")));
  }
  text += mass_sentence(input) + "</div>\n</div>\n";
  text += "<h3>The mesh model</h3>\n";
  text += input.meshes.empty() ? "<p>No mesh model has been run: foam/ holds none.</p>\n" : mesh_table(input.meshes);
  return text;
}

/// Who has set a constant. Where a case gives no largest speed, the resolved case holds the one that gencase has found.
std::string origin_of(const Constant& constant) {
  if (constant.is_default) return "<span class=\"soft\">default</span>";
  return constant.key == "maximum_speed" ? "case, or found by gencase" : "case";
}

std::string model(const ReportInput& input) {
  std::vector<std::vector<std::string>> switches;
  for (const Switch& entry : list_switches(input.resolved)) {
    switches.push_back({entry.on ? "<span class=\"on\">on</span>" : "<span class=\"off\">off</span>",
                        escape(entry.name), escape(entry.meaning)});
  }
  std::string text =
      "<h2>The model</h2>\n<h3>What is on, what is off</h3>\n" + html::table({"", "part", ""}, switches, "lll", "wide");
  std::vector<std::vector<std::string>> rows;
  for (const ConstantTable& table : list_constants(input.resolved)) {
    if (table.name == "case" || table.name == "compare") continue;  // stand elsewhere on the page
    rows.push_back({"<code>[" + escape(table.name) + "]</code>"});
    for (const Constant& constant : table.rows) {
      if (table.name == "shape") {
        rows.push_back({escape(constant.key), escape(constant.value), "case", html::typeset(constant.meaning)});
        continue;
      }
      rows.push_back({"<code>" + escape(constant.key) + "</code>", html::typeset(constant.value), origin_of(constant),
                      "<span class=\"soft\">" + escape(constant.meaning) + "</span>"});
    }
  }
  return text + "<h3>Constants</h3>\n" +
         html::table({"key", "value", "from", "meaning"}, rows, "llll", "long wide constants") +
         "<p class=\"small\">All of them: <a href=\"../case.resolved.toml\">case.resolved.toml</a>.</p>\n";
}

std::string remarks(const ReportInput& input) {
  if (input.warnings.empty()) return "<h2>Warnings</h2>\n<p>None.</p>\n";
  std::string text = "<h2>Warnings</h2>\n<div class=\"warnings\"><ul>\n";
  for (const std::string& warning : input.warnings) text += "<li>" + escape(warning) + "</li>\n";
  return text + "</ul></div>\n";
}

std::string provenance(const ReportInput& input) {
  const ParticleFileInfo& info = input.extraction.info;
  std::string text = "<h2>How this was made</h2>\n";
  text += fmt::format(
      "<p>The free surface is where the volume fraction of water and sediment crosses one half, the bed where that of "
      "sediment does, and the moving bed where that of sediment at rest ({}) does. The fraction is a kernel sum over "
      "the particles (Wendland C2, h = {:g} mm) on a grid of {:g} mm. Only bodies connected to the floor count, and in "
      "each column their highest crossing. Layers thinner than {:g} spacing count as absent.</p>\n",
      escape(input.extraction.rest_criterion), 1e3 * info.smoothing_length, 1e3 * info.spacing / 2, least_layer);
  std::vector<std::vector<std::string>> sources;
  for (const ProfileSet& set : input.sets) {
    std::string comments;
    if (set.kind != SourceKind::run && !set.profiles.empty()) {
      for (const std::string& line : comments_in(set.profiles.front().file)) comments += escape(line) + "<br>";
    }
    sources.push_back({escape(set.label), "<code>" + escape(set.origin.string()) + "</code>",
                       "<span class=\"small\">" + comments + "</span>"});
  }
  text += "<h3>Sources</h3>\n" + html::table({"source", "read from", "comments in its files"}, sources, "lll", "wide");
  std::string compare;
  for (const std::string& argument : input.compare_arguments) compare += " --compare " + argument;
  text += html::table(
      {},
      {{"solver", escape("thalweg " + info.code_version)},
       {"post-processing", escape("thalweg-postproc " + version())},
       {"hash of the case", "<code>" + escape(info.case_hash) + "</code>"},
       {"case file", "<code>" + escape(input.resolved.file.string()) + "</code>"},
       {"to make this page again", fmt::format("<code>thalweg-postproc {}{} {}</code>", escape(input.run.root.string()),
                                               escape(compare), input.in_space ? "--3d" : "--report")},
       {"to draw a picture again", "<code>cd report/pictures &amp;&amp; gnuplot t….gp</code>"},
       {"curves as drawn", "<code>report/data/</code>"}},
      "ll");
  return text;
}

}  // namespace thalweg::report_sections
