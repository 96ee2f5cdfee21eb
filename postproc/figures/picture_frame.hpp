#pragma once

#include <vector>

#include "postproc/profile_set.hpp"

namespace thalweg {

/// The place of the axes in a profile picture, in shares of its width and height from the lower left.
struct PlotArea {
  int width = 1000;  // [pixels] of the picture
  int height = 280;
  double left = 0.07;
  double right = 0.985;
  double bottom = 0.21;
  double top = 0.87;
};
inline constexpr PlotArea profile_area;

/// The part of the plane x-z that all profile pictures of a report show [m].
struct PictureFrame {
  double x_from = 0;
  double x_to = 1;
  double z_from = 0;
  double z_to = 1;

  /// The same with `margin` [m] more on every side.
  [[nodiscard]] PictureFrame widened(double margin) const {
    return {x_from - margin, x_to + margin, z_from - margin, z_to + margin};
  }

  /// Height over length of a square in a profile picture [-].
  [[nodiscard]] double exaggeration() const {
    const PlotArea& area = profile_area;
    return (x_to - x_from) / (z_to - z_from) * (area.top - area.bottom) * area.height /
           ((area.right - area.left) * area.width);
  }
};

/// The frame that holds all curves of all sets, with a margin above; x reaches from `from` to `to` [m] if `to` is
/// larger.
PictureFrame frame_around(const std::vector<ProfileSet>& sets, double from, double to);

}  // namespace thalweg
