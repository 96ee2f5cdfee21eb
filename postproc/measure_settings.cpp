#include "postproc/measure_settings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thalweg {

double rest_speed_of(const Case& resolved) {
  if (resolved.sediments.empty()) return ExtractionSettings{}.rest_speed;
  constexpr double share = 0.05;
  double smallest_grain = std::numeric_limits<double>::infinity();
  for (const auto& [name, sediment] : resolved.sediments) {
    smallest_grain = std::min(smallest_grain, sediment.grain_diameter);
  }
  return share * std::sqrt(resolved.domain.gravity.norm() * smallest_grain);
}

MeasureSettings settings_of(const Case& resolved, const std::vector<ProfileLine>& further_lines, bool surfaces) {
  MeasureSettings settings{resolved, {}, resolved.lines, surfaces};
  settings.lines.insert(settings.lines.end(), further_lines.begin(), further_lines.end());
  settings.profile.x_from = resolved.domain.from.x();
  settings.profile.x_to = resolved.domain.to.x();
  settings.profile.z_from = resolved.domain.from.z();
  settings.profile.z_to = resolved.domain.to.z();
  if (resolved.info.dimension == 3) {
    settings.profile.plane_y = (resolved.domain.from.y() + resolved.domain.to.y()) / 2;
    if (resolved.domain.is_periodic(1)) {
      settings.profile.y_from = resolved.domain.from.y();
      settings.profile.y_to = resolved.domain.to.y();
    }
  }
  settings.profile.rest_speed = rest_speed_of(resolved);
  return settings;
}

}  // namespace thalweg
