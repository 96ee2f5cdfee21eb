#pragma once

#include <string>
#include <vector>

#include "case/tables/table.hpp"

namespace thalweg {

/// [compare]: measurements, and the profiles compared with them.
struct Compare {
  static constexpr TableHeading heading{"compare", "What the result is compared with."};

  std::vector<double> times;      // [s]
  std::vector<double> bed_times;  // [s]
  std::vector<std::string> references;
  double from = 0;  // [m]
  double to = 0;    // [m]
  int runs = 1;
  int factor_runs = 1;

  template <class V>
  void describe(V& v) {
    v.quantities("times", times, "s", 0, 1e9,
                 "Times at which profiles are extracted and compared; snapshots are written there too.");
    v.quantities("bed_times", bed_times, "s", 0, 1e12,
                 "In place of times, for a bed that is a surface: times of the bed. Snapshots are written when it gets "
                 "there, and profiles are compared with t54000.000.csv and the like.");
    v.texts("references", references, "Folders with measured profiles (t0.250.csv …), relative to the case.");
    v.quantity("from", from, "m", -1e9, 1e9, "Start of the range compared; with `to` equal: the whole domain.");
    v.quantity("to", to, "m", -1e9, 1e9, "End of the range compared.");
    v.integer("runs", runs, 1, 4,
              "Particle runs that `thalweg run` makes, each with twice the spacing of the one before: what the spacing "
              "decides, and what it costs.");
    v.integer(
        "factor_runs", factor_runs, 1, 3,
        "Particle runs of a bed that is a surface that `thalweg run` makes, each with half the surface_bed.factor "
        "of the one before and over the same time of the bed: what the factor decides.");
  }

  void check(const Case& whole, const CheckContext& at) const;
};

}  // namespace thalweg
