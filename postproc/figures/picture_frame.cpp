#include "postproc/figures/picture_frame.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thalweg {

PictureFrame frame_around(const std::vector<ProfileSet>& sets, double from, double to) {
  const double infinite = std::numeric_limits<double>::infinity();
  PictureFrame frame{infinite, -infinite, infinite, -infinite};
  for (const ProfileSet& set : sets) {
    for (const TimedProfile& timed : set.profiles) {
      for (const Curve& curve : curves) {
        const std::vector<double>& values = timed.profile.*curve.values;
        for (std::size_t i = 0; i < values.size(); ++i) {
          if (std::isnan(values[i])) continue;
          frame.x_from = std::min(frame.x_from, timed.profile.x[i]);
          frame.x_to = std::max(frame.x_to, timed.profile.x[i]);
          frame.z_from = std::min(frame.z_from, values[i]);
          frame.z_to = std::max(frame.z_to, values[i]);
        }
      }
    }
  }
  if (!(frame.x_from < frame.x_to)) return {};
  if (to > from) {
    frame.x_from = from;
    frame.x_to = to;
  }
  // A floor at zero is worth showing where the curves are not far above it.
  if (frame.z_from > 0 && frame.z_from < frame.z_to) frame.z_from = 0;
  frame.z_to += 0.08 * (frame.z_to - frame.z_from) + 1e-6;
  return frame;
}

}  // namespace thalweg
