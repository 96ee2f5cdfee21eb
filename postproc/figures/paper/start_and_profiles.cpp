#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "common/csv.hpp"
#include "common/io/particle_file.hpp"
#include "postproc/figures/paper/paper_part.hpp"
#include "postproc/html.hpp"
#include "postproc/report_sections.hpp"

namespace thalweg::paper {
namespace {

namespace fs = std::filesystem;

// "free surface 2.3 mm, bed 2.7 mm": distance of the run from a source at a time.
std::string rmse(const ReportInput& input, const ProfileSet& reference, double time) {
  std::vector<std::string> found;
  for (const Curve& curve : curves) {
    for (const CurveError& error : input.comparison.errors) {
      if (error.reference != reference.label || error.compared != input.sets.front().label) continue;
      if (!error.line.empty() || error.curve != curve.name || std::abs(error.time - time) > same_time) continue;
      found.push_back(fmt::format("{} {:.1f} mm", curve.title, 1e3 * error.rmse));
    }
  }
  return fmt::format("{}", fmt::join(found, ", "));
}

std::string profile_figure(const Context& context, const TimedProfile& timed) {
  const ReportInput& input = context.input;
  std::string caption = fmt::format("t = {:g} s.", timed.time);
  for (std::size_t s = 1; s < input.sets.size(); ++s) {
    const std::string distance = rmse(input, input.sets[s], timed.time);
    if (distance.empty()) continue;
    caption += fmt::format(" RMSE of SPH against {}: {}.", html::escape(input.sets[s].label), distance);
  }
  const fs::path picture = context.folder / (picture_name(timed.time) + ".svg");
  return report_sections::figure(html::inline_svg(picture, report_sections::id_of_profile(timed.time),
                                                  fmt::format("Profiles at t = {:g} s", timed.time)),
                                 caption);
}

}  // namespace

Part start_and_profiles(const Context& context) {
  const ReportInput& input = context.input;
  const PictureFrame frame = frame_around(input.sets, input.resolved.compare.from, input.resolved.compare.to);
  Part part;
  if (fs::exists(input.run.particles())) {
    constexpr std::size_t most_points = 200'000;
    const ParticleTable start =
        write_particle_table(context.data("fig08_start.csv"), read_particles(input.run.particles()),
                             input.extraction.plane_y, most_points, true);
    part.scripts.push_back(context.writer.scene(start, frame.widened(3.5 * context.spacing), context.spacing));
  }
  std::vector<fs::path> folders;
  for (const ProfileSet& set : input.sets) {
    folders.push_back(context.folder / "data" / folder_name_of(set.label));
    for (const TimedProfile& timed : set.profiles) {
      write_profile(folders.back() / profile_file_name(timed.time), timed.profile, comments_in(timed.file));
    }
  }
  for (const TimedProfile& timed : input.extraction.written) {
    part.scripts.push_back(context.writer.profiles(timed.time, input.sets, folders, frame, height_unit(0, 0)));
  }
  part.html = [&context] {
    std::string text = "<h2>Figures 8 to 10: the start, and profiles with their RMSE</h2>\n" +
                       report_sections::figure(html::inline_png(context.folder / "scene.png", "The start"),
                                               "The start, heights not exaggerated.");
    for (const TimedProfile& timed : context.input.extraction.written) text += profile_figure(context, timed);
    return text + context.measured_slot();
  };
  return part;
}

}  // namespace thalweg::paper
