#include "postproc/report_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "postproc/figures/picture_frame.hpp"
#include "postproc/report.hpp"

namespace thalweg {

std::string PageUnit::number(double value) const {
  return std::isnan(value) ? "–" : fmt::format("{:.{}f}", value / size, decimals);
}

std::string PageUnit::signed_number(double value) const {
  if (std::isnan(value)) return "–";
  std::string text = fmt::format("{:+.{}f}", value / size, decimals);
  if (text.find_first_of("123456789") == std::string::npos) return text.substr(1);
  if (text.front() == '-') text.replace(0, 1, "\u2212");
  return text;
}

std::string PageUnit::text(double value) const { return number(value) + "\u00a0" + name; }

std::string PageUnit::text_or_less(double value) const {
  const double least = size * std::pow(10, -decimals);
  return value < least ? "less than " + text(least) : text(value);
}

std::string PageUnit::drawn() const {
  std::string text = name;
  for (const auto& [plain, raised] : {std::pair{"^2", "²"}, {"^3", "³"}}) {
    if (const std::size_t at = text.find(plain); at != std::string::npos) text.replace(at, 2, raised);
  }
  return text;
}

std::string PageUnit::factor() const { return fmt::format("{:.9g}", 1 / size); }

PageUnit height_unit(double change, double range) {
  constexpr double large_change = 1;  // [m]
  constexpr double deep_water = 5;    // [m]
  if (change >= large_change || range >= deep_water) return {"m", 1, 3};
  return {"mm", 1e-3, 1};
}

PageUnit time_unit(double longest) {
  constexpr double minute = 60;
  constexpr double hour = 3600;
  constexpr double day = 86400;
  if (longest < 2 * minute) return {"s", 1, 1};
  if (longest < 2 * hour) return {"min", minute, 1};
  if (longest < 2 * day) return {"h", hour, 1};
  return {"d", day, 1};
}

PageUnit volume_unit(double largest, int dimension) {
  constexpr double large_area = 0.1;     // [m^2]
  constexpr double large_volume = 0.01;  // [m^3]
  if (dimension == 2) return largest < large_area ? PageUnit{"cm^2", 1e-4, 1} : PageUnit{"m^2", 1, 3};
  return largest < large_volume ? PageUnit{"cm^3", 1e-6, 1} : PageUnit{"m^3", 1, 4};
}

int decimals_of_places(double spacing) {
  constexpr double wide = 0.2;    // [m]
  constexpr double close = 0.02;  // [m]
  return spacing >= wide ? 2 : spacing >= close ? 3 : 4;
}

ReportUnits units_of(const ReportInput& input) {
  ReportUnits units;
  double change = 0;
  double volume = 0;
  for (std::size_t n = 0; n < input.series.time.size(); ++n) {
    change = std::fmax(change, std::fmax(input.series.scour[n], input.series.deposition[n]));
    volume = std::fmax(volume, std::fmax(input.series.eroded[n], input.series.deposited[n]));
  }
  const PictureFrame frame = frame_around(input.sets, 0, 0);
  units.height = height_unit(change, frame.z_to - frame.z_from);
  units.place.decimals = decimals_of_places(input.extraction.info.spacing);
  if (!input.scour.time.empty()) units.bed_time = time_unit(input.scour.time.back());
  units.volume = volume_unit(volume, input.resolved.info.dimension);
  double longest = 0;
  const auto take = [&](const std::vector<Quantity>& summary) {
    for (const char* name : {"wall_seconds", "cpu_seconds"}) {
      longest = std::max(longest, number_of(summary, name).value_or(0));
    }
  };
  take(input.summary);
  for (const MeshModel& mesh : input.meshes) take(mesh.summary);
  units.cost = time_unit(longest);
  return units;
}

}  // namespace thalweg
