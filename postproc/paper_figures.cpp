#include "postproc/paper_figures.hpp"

#include <fmt/format.h>

#include <ostream>

#include "common/console.hpp"
#include "common/whole_file.hpp"
#include "postproc/figures/paper/paper_part.hpp"
#include "postproc/gnuplot.hpp"
#include "postproc/html.hpp"
#include "postproc/report_sections.hpp"
#include "postproc/report_style.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

bool draw(const std::vector<paper::Part>& parts, std::vector<std::string>& warnings) {
  std::vector<fs::path> scripts;
  for (const paper::Part& part : parts) scripts.insert(scripts.end(), part.scripts.begin(), part.scripts.end());
  return draw_pictures(scripts, warnings);
}

void write_page(const fs::path& page, const paper::Context& context, const std::vector<paper::Part>& parts) {
  const ReportInput& input = context.input;
  write_whole_text(page, [&](std::ostream& stream) {
    stream
        << "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>The paper's figures</title><style>"
        << report_style << "</style></head><body>\n"
        << report_sections::heading(input)
        << "<p>The figures of Zhang, Xiong &amp; Liu (2024), numbered as there, from runs of this program; OpenFOAM "
           "stands in the place of their mesh code. Sources: ";
    for (std::size_t s = 0; s < input.sets.size(); ++s) {
      stream << (s > 0 ? "; " : "") << html::escape(input.sets[s].label);
    }
    stream << (context.has_measurement()
                   ? ".</p>\n"
                   : "; <b>nothing measured</b>, so none of this is agreement with the experiment.</p>\n");
    for (const paper::Part& part : parts) stream << part.html();
    stream << report_sections::provenance(input) << "</body></html>\n";
  });
}

}  // namespace

bool write_paper_figures(ReportInput& input, const std::vector<fs::path>& series) {
  const paper::Context context(input);
  std::vector<paper::Part> parts;
  parts.push_back(paper::front_against_spacing(context, series));
  parts.push_back(paper::start_and_profiles(context));
  parts.push_back(paper::sections(context));
  if (std::optional<paper::Part> scour = paper::scour_against_time(context)) parts.push_back(std::move(*scour));
  const bool drawn = draw(parts, input.warnings);
  const fs::path page = context.folder / "index.html";
  write_page(page, context, parts);
  say(fmt::format("\nfigures: {}", page.string()));
  return drawn;
}

}  // namespace thalweg
