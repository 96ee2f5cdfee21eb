#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "case/tables/table.hpp"

namespace thalweg {

/// The words of flow.drive.
enum class Drive { off, slope, discharge, velocity };

inline constexpr std::array<Choice<Drive>, 4> choices(Drive) {
  return {{{Drive::off, "off", "nothing drives the water"},
           {Drive::slope, "slope", "as gravity does down a slope, by g times `slope`"},
           {Drive::discharge, "discharge", "so that the discharge per width is `discharge`"},
           {Drive::velocity, "velocity", "so that the mean velocity of the water is `velocity`"}}};
}

/// The words of flow.start.
enum class FlowStart { rest, uniform, log_law };

inline constexpr std::array<Choice<FlowStart>, 3> choices(FlowStart) {
  return {{{FlowStart::rest, "rest", "the water stands still"},
           {FlowStart::uniform, "uniform", "with the mean velocity of the current at all heights"},
           {FlowStart::log_law, "log-law", "with the logarithmic profile over the bed or floor below each place"}}};
}

/// [flow]: a current around a periodic flume.
struct Flow {
  static constexpr TableHeading heading{
      "flow", "A current that lasts: water driven around a period of the domain.",
      "What leaves the domain at one end enters it at the other. The drive is a uniform acceleration of the water; the "
      "surface stays level, and the pressure hydrostatic. In driven scenes smoothing_ratio is 2, artificial_viscosity "
      "0.1 (switched) and shifting on where the case does not say otherwise: without them the lattice of particles "
      "carries shear like dry friction."};

  Drive drive = Drive::off;
  std::string along = "x";
  double slope = 0;         // [-]
  double discharge = 0;     // [m^2/s]
  double velocity = 0;      // [m/s]
  double guide_from = 0;    // [m]
  double guide_length = 0;  // [m]
  FlowStart start = FlowStart::rest;
  std::vector<std::string> start_of;

  template <class V>
  void describe(V& v) {
    v.choice("drive", drive, "What drives the water along the flow.");
    v.text("along", along, "Direction of the flow, \"x\" or \"y\"; domain.periodic has to name it.");
    v.number("slope", slope, 0, 0.2, "drive = \"slope\": fall of the flume over its length.");
    v.quantity("discharge", discharge, "m^2/s", 0, 1000,
               "drive = \"discharge\": volume per time and width, the width being that of the water seen from above.");
    v.quantity("velocity", velocity, "m/s", 0, 100, "drive = \"velocity\": mean over the volume of the water.");
    v.quantity("guide_length", guide_length, "m", 0, 1e6,
               "Length of a zone that turns what comes around the period back into the current of an endless flume: "
               "over it the water takes the logarithmic profile over the ground, at its own discharge. Behind a body "
               "the wake would come around and meet it. 0: none. Mesh models have none.");
    v.quantity("guide_from", guide_from, "m", -1e6, 1e6,
               "Where the zone begins, along the flow; it may reach over the end of the period.");
    v.choice("start", start,
             "Velocity of the water at the start. It follows from the drive (without one, beside inlets, from "
             "`discharge` or `velocity`) and the law of the wall with the depth of each column; a current that starts "
             "at rest takes some ten depths over the friction velocity to become steady.");
    v.texts("start_of", start_of, "Names of the shapes whose water starts so; without any, all water does.");
  }

  /// Component of vectors along the flow: 0 for x, 1 for y.
  [[nodiscard]] int component() const { return along == "x" ? 0 : 1; }
  [[nodiscard]] bool uses_key(std::string_view key, int dimension) const;
  void check(const Case& whole, const CheckContext& at) const;
};

}  // namespace thalweg
