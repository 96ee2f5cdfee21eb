// Both methods side by side: speed against error, and the own uncertainty of each mesh model.
#include <fmt/format.h>

#include <cmath>

#include "postproc/figures/figure_writer.hpp"
#include "postproc/figures/method_figures.hpp"
#include "postproc/html.hpp"
#include "postproc/report_sections.hpp"

namespace thalweg::report_sections {
namespace {

namespace fs = std::filesystem;

}  // namespace

std::string methods(const ReportInput& input, const fs::path& pictures) {
  if (input.methods.empty()) return "";
  std::string text = "<h2>Speed against error</h2>\n";
  std::vector<std::vector<std::string>> rows;
  const PageUnit& height = input.units.height;
  bool bands = false;
  for (const Method& method : input.methods) {
    bands = bands || has_band(method);
    for (const MethodRun& run : method.runs) {
      const bool finest = &run == &method.runs.front();
      rows.push_back({html::escape(run.label), html::grouped(run.elements), html::grouped(run.steps),
                      input.units.cost.number(run.cpu_seconds), html::grouped(run.element_steps_per_second()),
                      finest ? "finest" : height.number(run.error_free_surface),
                      finest ? "finest" : height.number(run.error_bed)});
    }
  }
  text += html::table(
      {"method", "particles or cells", "steps", fmt::format("CPU [{}]", input.units.cost.name), "element steps / CPU s",
       fmt::format("free surface, distance from the finest [{}]", height.name), fmt::format("bed [{}]", height.name)},
      rows, "lrrrrrr", "wide");
  const std::string cost = html::inline_svg(pictures / "cost.svg", "cost", "Speed against error of both methods");
  if (!cost.empty()) {
    text +=
        "<div class=\"pair\">\n<figure>\n" + cost +
        "<figcaption>CPU time of each run, and the distance of its bed, or of its free surface without a bed, from the "
        "finest run of the same method. The finest runs themselves are not shown. The distance shows the effect of the "
        "resolution; it does not show how close a method is to reality.</figcaption>\n</figure>\n</div>\n";
  }
  text += "<p class=\"small\">Root mean square over all times compared; <a href=\"cost.csv\">cost.csv</a>.</p>\n";
  if (!bands) return text;
  text += "<h2>How sure the mesh models are</h2>\n";
  for (const TimedProfile& timed : input.sets.front().profiles) {
    const std::string name = picture_name(timed.time);
    const std::string picture = html::inline_svg(pictures / ("band_" + name + ".svg"), "band" + name,
                                                 fmt::format("Mesh models and their bands at t = {:g} s", timed.time));
    if (!picture.empty()) text += "<figure>\n" + picture + "</figure>\n";
  }
  return text +
         "<p>A line is a mesh model; its band reaches to the same model on cells twice as large. The band is the mesh "
         "model's own uncertainty: a particle model that lies inside the band cannot be distinguished from the mesh "
         "model.</p>\n";
}

}  // namespace thalweg::report_sections
