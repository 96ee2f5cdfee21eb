// The report's parts that are pictures with captions: profiles, front, energies, particles.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "postproc/figures/figure_writer.hpp"
#include "postproc/html.hpp"
#include "postproc/report_sections.hpp"

namespace thalweg::report_sections {

std::string figure(const std::string& picture, const std::string& caption, const std::string& id) {
  const std::string shown =
      picture.empty() ? "<div class=\"missing\">no picture: the remarks say why it was not drawn</div>" : picture;
  const std::string named = id.empty() ? "" : " id=\"figure_" + id + "\"";
  return fmt::format("<figure{}>\n{}<figcaption>{}</figcaption>\n</figure>\n", named, shown, caption);
}

std::string id_of_profile(double time) {
  std::string name = picture_name(time);
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
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
  text += ". The colour tells which curve it is; ";
  std::vector<std::string> kinds{"a full line is this SPH run"};
  const auto has = [&](SourceKind kind) {
    return std::any_of(input.sets.begin(), input.sets.end(), [&](const ProfileSet& set) { return set.kind == kind; });
  };
  if (has(SourceKind::mesh)) kinds.emplace_back("a dashed or dotted one a mesh model");
  if (has(SourceKind::other)) kinds.emplace_back("a dash-dotted one a further source");
  if (has(SourceKind::measured)) kinds.emplace_back("open markers are measured");
  const PictureFrame frame = frame_around(input.sets, input.resolved.compare.from, input.resolved.compare.to);
  constexpr double visible = 1.05;  // below it a picture has its true shape
  const double times = frame.exaggeration();
  text += fmt::format("{}. {}</p>\n", fmt::join(kinds, ", "),
                      times < visible ? "Heights and lengths have one scale."
                                      : fmt::format("Heights are exaggerated {:.1f} times.", times));
  for (const TimedProfile& timed : input.extraction.written) {
    const std::string name = picture_name(timed.time);
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

std::string front_and_energies(const ReportInput& input, const std::filesystem::path& pictures) {
  const std::string width = input.resolved.info.dimension == 2 ? ", per metre of width" : "";
  // Of a current that lasts, the front is no event.
  const bool front = has_front(input.extraction) && !input.resolved.has_lasting_current();
  if (!front && input.history.rows == 0) return "";
  std::string text = fmt::format("<h2>{}</h2>\n<div class=\"pair\">\n", front ? "Front and energies" : "Energies");
  if (front) {
    text +=
        figure(html::inline_svg(pictures / "front.svg", "front", "Water front against time"),
               fmt::format("Water front: largest x with more than {} of water over the bed (half a spacing), all "
                           "sources measured alike. Numbers: <a href=\"../profiles/front.csv\">profiles/front.csv</a>, "
                           "<a href=\"fronts.csv\">report/fronts.csv</a>.",
                           input.units.height.text(least_layer * input.extraction.info.spacing)));
  }
  if (input.history.rows > 0) {
    text +=
        figure(html::inline_svg(pictures / "energies.svg", "energies", "Energies against time"),
               fmt::format("Energies of water and sediment{}; potential and internal energy as change from the start. "
                           "The sum falls by what friction dissipates. Numbers: <a "
                           "href=\"../history.csv\">history.csv</a>.",
                           width));
  }
  return text + "</div>\n";
}

std::string particles(const ReportInput& input, const std::filesystem::path& pictures) {
  const std::string picture = html::inline_png(pictures / "particles.png", "Particles at the last time");
  return "<h2>The particles</h2>\n" +
         figure(picture, fmt::format("The particles at t = {:g} s{}, heights not exaggerated: kind, speed and pressure "
                                     "(sediment at rest keeps the pressure it had when it stopped). Open "
                                     "<code>snapshots.pvd</code> in ParaView for all times.",
                                     input.extraction.last_time,
                                     input.resolved.info.dimension == 3
                                         ? fmt::format(", in the plane y = {:g} m", input.extraction.plane_y)
                                         : ""));
}

}  // namespace thalweg::report_sections
