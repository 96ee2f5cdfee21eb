#pragma once

#include <string>
#include <vector>

#include "case/tables/table.hpp"
#include "common/particles.hpp"

namespace thalweg {

/// [domain]: the box in which the scene takes place, and gravity.
struct Domain {
  static constexpr TableHeading heading{"domain", "Where it takes place."};

  Vec3 from = Vec3::Constant(required);  // [m]
  Vec3 to = Vec3::Constant(required);    // [m]
  Vec3 gravity{0, 0, -9.81};             // [m/s^2]
  std::vector<std::string> periodic;

  /// True if the domain repeats itself along x (axis 0), y or z.
  [[nodiscard]] bool is_periodic(int axis) const;

  template <class V>
  void describe(V& v) {
    v.point("from", from, "m", "Lower corner of the domain; particles that leave the domain are excluded and counted.");
    v.point("to", to, "m", "Upper corner of the domain.");
    v.point("gravity", gravity, "m/s^2", "Acceleration of gravity.");
    v.texts("periodic", periodic, "Directions in which the domain repeats itself: any of \"x\", \"y\", \"z\".");
  }

  void check(const Case& whole, const CheckContext& at) const;
};

}  // namespace thalweg
