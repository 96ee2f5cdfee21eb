#pragma once

#include <string_view>

#include "case/models/surface_bed.hpp"
#include "case/tables/table.hpp"

namespace thalweg {

/// [surface_bed]: how a bed that is a surface follows the water (sediment = "surface").
struct SurfaceBedSettings {
  static constexpr TableHeading heading{"surface_bed",
                                        "How a bed that is a surface follows the water (sediment = \"surface\")."};

  double factor = 1000;  // [-]
  double step = 0.25;    // [spacings]
  double window = 0;     // [s]
  double spin_up = 0;    // [s]
  double end = 0;        // [s] of the bed's time
  BedFeed feed = BedFeed::equilibrium;
  BedLoadAdaptation adaptation = BedLoadAdaptation::none;
  double grain_stress = 1;  // [-]

  template <class V>
  void describe(V& v) {
    v.number(
        "factor", factor, 1, 1e6,
        "Largest morphological factor: time that a change of the bed stands for, over the time in which the water's "
        "stress was found. With 1 the bed changes in step with the water; more is used only as far as `step` lets.");
    v.number("step", step, 0.01, 0.25,
             "Largest change of the bed's level between two windows [spacings]; half of it halves the factor.");
    v.quantity("window", window, "s", 0, 1e6,
               "Time over which the water's shear stress is averaged before the bed moves; twice as long where its two "
               "halves differ by more than 10 %. 0: the time of 50 spacings at numerics.maximum_speed.");
    v.quantity("spin_up", spin_up, "s", 0, 1e6, "Time in which the flow forms and the bed stays as it is.");
    v.quantity(
        "end", end, "s", 0, 1e12,
        "Time of the bed at which the run ends, if output.end has not come before. 0: output.end alone ends it.");
    v.choice("feed", feed, "Bed load that comes in with the water of an inlet.");
    v.choice("adaptation", adaptation,
             "Way of the grains from a place where none move, or from another stress, to the law's rate of bed load.");
    v.number("grain_stress", grain_stress, 0.01, 1,
             "Share of the water's shear stress on the bed that moves grains. Ripples smaller than a spacing take the "
             "rest, where the bed's roughness is theirs.");
  }

  void check(const Case& whole, const CheckContext& at) const;
};

}  // namespace thalweg
