#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "case/tables/table.hpp"
#include "common/particles.hpp"

namespace thalweg {

enum class MotionKind { piecewise_linear, rotation, gate_lift, oscillation, sliding_surface };

inline constexpr std::array<Choice<MotionKind>, 5> choices(MotionKind) {
  return {{{MotionKind::piecewise_linear, "piecewise linear",
            "along `direction` by `displacements` at `times`, or by the table in `file`; at rest before and after"},
           {MotionKind::rotation, "rotation",
            "about `axis` through `center`, from `start` on with `angular_speed`, or by `angles` at `times`, or by the "
            "table in `file`"},
           {MotionKind::gate_lift, "gate lift",
            "along `direction` from `start` on, with `speed` at once, or with `acceleration` until it has `speed` (for "
            "ever without `speed`); stops after `distance`"},
           {MotionKind::oscillation, "oscillation",
            "along `direction` from `start` on by amplitude (1 - cos(2 pi t/period)): from rest at one end of a stroke "
            "of twice the amplitude"},
           {MotionKind::sliding_surface, "sliding surface",
            "the walls stay in place and their surface runs along `direction` from `start` on, as a belt does, with "
            "`speed` at once, or with `acceleration` until it has `speed` (for ever without `speed`)"}}};
}

/// One [[motion]]: how moving walls move. At t = 0 they are where their shapes put them, whatever a table says there.
struct Motion {
  static constexpr TableHeading heading{"motion",
                                        "How moving walls move: one such table for every motion (geometry.md)."};

  std::string name;
  MotionKind kind = MotionKind::piecewise_linear;
  Vec3 direction = Vec3::Zero();      // [-]
  std::vector<double> times;          // [s]
  std::vector<double> displacements;  // [m]
  std::vector<double> angles;         // [rad]
  std::string file;
  Vec3 center = Vec3::Zero();  // [m]
  Vec3 axis = Vec3::Zero();    // [-]
  double angular_speed = 0;    // [rad/s]
  double start = 0;            // [s]
  double speed = 0;            // [m/s]
  double acceleration = 0;     // [m/s^2]
  double distance = 0;         // [m]
  double amplitude = 0;        // [m]
  double period = 0;           // [s]

  template <class V>
  void describe(V& v) {
    v.text("name", name, "Name of the motion, unique in the case.");
    v.choice("kind", kind, "How it goes.");
    v.direction("direction", direction, "all but rotation: where to; any length.");
    v.quantities("times", times, "s", 0, 1e9, "piecewise linear, rotation: times of the table, increasing.");
    v.quantities("displacements", displacements, "m", -1e6, 1e6,
                 "piecewise linear: way along `direction` at `times`, counted from the one at t = 0.");
    v.quantities("angles", angles, "rad", -1e6, 1e6,
                 "rotation: angle about `axis` at `times`, counted from the one at t = 0.");
    v.text(
        "file", file,
        "piecewise linear, rotation: the table as CSV, relative to the case's folder: time [s], and displacement [m] "
        "or angle [rad] or angle [deg].");
    v.point("center", center, "m", "rotation: a point on the axis (the hinge of a flap).");
    v.direction(
        "axis", axis,
        "rotation in 3-D: direction of the axis, turned about by the right-hand rule; in 2-D angles are counted "
        "counter-clockwise, x to the right and z upwards.");
    v.quantity("angular_speed", angular_speed, "rad/s", -1e6, 1e6, "rotation: angle per time, without a table.");
    v.quantity("start", start, "s", 0, 1e9, "all but tables: when it begins.");
    v.quantity("speed", speed, "m/s", 0, 1e4, "gate lift, sliding surface: final speed; 0: as `acceleration` has it.");
    v.quantity("acceleration", acceleration, "m/s^2", 0, 1e6,
               "gate lift, sliding surface: how fast it gets there; 0: at once.");
    v.quantity("distance", distance, "m", 0, 1e6, "gate lift: after which it stops at once; 0: never.");
    v.quantity("amplitude", amplitude, "m", 0, 1e6, "oscillation: half the stroke.");
    v.quantity("period", period, "s", 0, 1e9, "oscillation: time of one to and fro.");
  }

  /// A rotation by a table has no `start`: check() refuses it.
  [[nodiscard]] bool uses_key(std::string_view key, int dimension) const;
  [[nodiscard]] std::vector<std::string> needs_keys(int dimension) const;
  void check(const Case& whole, const CheckContext& at) const;
  /// The rows of a motion's file become its own, so that the resolved case holds them. Throws InputError for a bad
  /// table.
  void read_files(const std::filesystem::path& folder);
  static Motion without_defaults();
};

}  // namespace thalweg
