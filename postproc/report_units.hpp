#pragma once

#include <string>

namespace thalweg {

struct ReportInput;

/// A unit in which a page shows one quantity.
struct PageUnit {
  std::string name = "m";  // as it is read: "mm", "m^2"
  double size = 1;         // [SI] of one unit
  int decimals = 3;

  /// "17.7"; an en dash where there is no value.
  [[nodiscard]] std::string number(double value) const;
  /// "+17.7", "0.0", "−17.7".
  [[nodiscard]] std::string signed_number(double value) const;
  /// "17.7 mm".
  [[nodiscard]] std::string text(double value) const;
  /// The same for the size of a difference: "less than 0.1 mm" where it is 0 with these decimals.
  [[nodiscard]] std::string text_or_less(double value) const;
  /// The unit as a picture shows it: "cm²".
  [[nodiscard]] std::string drawn() const;
  /// The factor from SI to this unit, as a gnuplot script writes it.
  [[nodiscard]] std::string factor() const;
};

/// The units of one page: one for each quantity, chosen by its magnitude in the run. The water's time is in s.
struct ReportUnits {
  PageUnit height{"mm", 1e-3, 1};    // heights and their changes: bed, scour, free surface, distances between them
  PageUnit place{"m", 1, 3};         // x and y
  PageUnit bed_time{"s", 1, 1};      // time that the bed's changes stand for
  PageUnit volume{"cm^3", 1e-6, 0};  // of the bed that has changed; per width in 2-D
  PageUnit cost{"s", 1, 1};          // wall-clock and processor time
};

/// The unit of heights whose largest change is `change` and that lie within `range` [m].
PageUnit height_unit(double change, double range);
/// The unit of times up to `longest` [s].
PageUnit time_unit(double longest);
/// The unit of volumes up to `largest` [m^3]; in 2-D per width [m^2].
PageUnit volume_unit(double largest, int dimension);

/// Decimals of places in m that tell a twentieth of a spacing [m].
int decimals_of_places(double spacing);

ReportUnits units_of(const ReportInput& input);

}  // namespace thalweg
