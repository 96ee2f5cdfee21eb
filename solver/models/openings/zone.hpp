#pragma once

#include <cmath>

#include "physics/host_device.hpp"
#include "solver/state/record.hpp"

namespace thalweg {

/// An opening on the device. Its coordinates count from the centre: along the flow, upwards, and across [m]; an inlet's
/// zone lies at along < 0, an outlet's at along > 0.
struct Zone {
  double at[3] = {};  // [m] its centre
  double flow[3] = {};
  double up[3] = {};
  double across[3] = {};
  double half_up = 0;      // [m]
  double half_across = 0;  // [m] in 2-D more than anything
  bool round = false;
  double length = 0;     // [m] of the zone
  double spacing = 0;    // [m]
  bool enters = false;   // an inlet
  bool falls = false;    // an outlet that holds nothing back
  bool pumps = false;    // an outlet that takes a given volume per time
  bool is_full = false;  // an inlet without a surface: its pressure follows that of the water next to it
  bool upright = false;  // water has a depth in it
  bool feeds = false;    // an inlet that brings bed load
  // Columns of an inlet's particles along the flow, and the first of them in the table of all inlets.
  Index rows = 0;   // upwards
  Index ranks = 0;  // across
  Index first_column = 0;
};

/// The scene's water next to an opening, as the last step has left it.
struct BesideOpening {
  double pressure = 0;  // [Pa] at the opening's centre, for full inlets
  double speed = 0;     // [m/s] along the flow, for outlets; of a pump, with which it takes the water
  double change = 0;    // [m/s] of the speed in the last step
  double swell = 0;     // [m] by which an outlet's level gives way to a wave
  double entry = 0;     // [m/s] that water gains where it crosses a pump's plane
  double share = 0;     // of its deviation from that speed that a particle in an outlet's zone loses [-]
};

/// Coordinates of a place in an opening [m].
struct InOpening {
  double along;
  double up;
  double across;
};

HOST_DEVICE inline InOpening in_opening(const Zone& zone, const double* x) {
  InOpening in{0, 0, 0};
  for (int c = 0; c < 3; ++c) {
    const double from = x[c] - zone.at[c];
    in.along += from * zone.flow[c];
    in.up += from * zone.up[c];
    in.across += from * zone.across[c];
  }
  return in;
}

/// True if a place lies in the opening's cross-section, or within `margin` of it [m].
HOST_DEVICE inline bool is_in_section(const Zone& zone, const InOpening& in, double margin) {
  if (zone.round) {
    const double most = zone.half_up + margin;
    return in.up * in.up + in.across * in.across <= most * most;
  }
  return in.up >= -zone.half_up - margin && in.up <= zone.half_up + margin && in.across >= -zone.half_across - margin &&
         in.across <= zone.half_across + margin;
}

/// True if a place lies in the zone of an opening. Two spacings are left beyond its end, for what moves until lists are
/// made anew.
HOST_DEVICE inline bool is_in_zone(const Zone& zone, const InOpening& in) {
  const double margin = 0.01 * zone.spacing;
  const double end = zone.length + 2 * zone.spacing;
  const bool beside = zone.enters ? in.along >= -end && in.along < 0 : in.along >= 0 && in.along < end;
  return beside && is_in_section(zone, in, margin);
}

/// True if a place lies in the row of particles below an inlet's lower edge that its bed load is made of.
HOST_DEVICE inline bool is_in_feed(const Zone& zone, const InOpening& in) {
  const double margin = 0.01 * zone.spacing;
  const double over_middle = in.up + zone.half_up + 0.5 * zone.spacing;
  return in.along >= -(zone.length + 2 * zone.spacing) && in.along < 0 && fabs(over_middle) < 0.5 * zone.spacing &&
         fabs(in.across) <= zone.half_across + margin;
}

/// Number of the column in which a place in an inlet's zone lies, in the table of all inlets.
HOST_DEVICE inline Index column_in(const Zone& zone, const InOpening& in) {
  const auto part = [](double x, double half, Index parts) {
    const double at = (x + half) / (2 * half) * parts;
    const Index n = at > 0 ? static_cast<Index>(at) : 0;
    return n < parts ? n : parts - 1;
  };
  const Index row = part(in.up, zone.half_up, zone.rows);
  return zone.first_column + row * zone.ranks + (zone.ranks > 1 ? part(in.across, zone.half_across, zone.ranks) : 0);
}

/// The speed of a column without water.
inline constexpr float dry_column = -1;

}  // namespace thalweg
