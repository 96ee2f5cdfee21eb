#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "case/tables/table.hpp"
#include "common/particles.hpp"

// Openings of the scene: planes through which water enters ([[inlet]], inlet.hpp) and leaves ([[outlet]], outlet.hpp).
namespace thalweg {

/// Axes of an opening, each a unit vector: along the flow, upwards in the opening, and across it. Looking along the
/// flow, `across` points to the left.
struct OpeningAxes {
  Vec3 flow = Vec3::UnitX();
  Vec3 up = Vec3::UnitZ();
  Vec3 across = Vec3::UnitY();
};

/// The keys that inlets and outlets share.
struct Opening {
  std::string name;
  Vec3 at = Vec3::Zero();         // [m]
  Vec3 direction = Vec3::Zero();  // [-]
  double height = 0;              // [m]
  double width = 0;               // [m]
  double diameter = 0;            // [m]
  std::vector<double> times;      // [s]
  std::vector<double> levels;     // [m]
  double level = 0;               // [m]
  std::string file;

  template <class V>
  void describe_place(V& v, const char* meaning_of_name) {
    v.text("name", name, meaning_of_name);
    v.point("at", at, "m", "Centre of the opening.");
    v.direction("direction", direction, "Direction of the flow through it, any; the opening is the plane across it.");
    v.quantity("height", height, "m", 0, 1e6,
               "Extent of the opening in its plane, upwards; along x where the flow is vertical.");
    v.quantity("width", width, "m", 0, 1e6, "In space: extent in its plane, across the height.");
    v.quantity("diameter", diameter, "m", 0, 1e6, "In space, in place of height and width: of a round opening.");
  }

  /// True if key is one of those above; and if it means something.
  [[nodiscard]] static bool is_place(std::string_view key);
  [[nodiscard]] bool uses_place(std::string_view key, int dimension) const;
  [[nodiscard]] bool is_round() const { return diameter > 0; }
  /// Its extent upwards [m], and across [m]: 1 m in 2-D.
  [[nodiscard]] double extent_up() const { return is_round() ? diameter : height; }
  [[nodiscard]] double extent_across(int dimension) const;
  /// [m^2]; per metre of width in 2-D.
  [[nodiscard]] double area(int dimension) const;
  [[nodiscard]] OpeningAxes axes() const;
  /// Height z of its lower edge [m].
  [[nodiscard]] double lower_edge() const { return at.z() - 0.5 * extent_up() * axes().up.z(); }
  [[nodiscard]] double upper_edge() const { return at.z() + 0.5 * extent_up() * axes().up.z(); }
  /// A level at a time [s]: that of the table, linear between its rows, constant before and after; else `level`.
  [[nodiscard]] double level_at(double time) const;

  /// Checks the keys above.
  void check_place(const Case& whole, const CheckContext& at_table) const;
  /// `times` increase, and `values` of the key `column` are as many.
  void check_times(const CheckContext& at_table, const std::string& column, const std::vector<double>& values) const;
  /// Levels lie within the opening, which stands upright.
  void check_levels(const Case& whole, const CheckContext& at_table) const;
};

/// Linear between the rows of a table over time, constant before and after; `otherwise` without rows.
double value_at(const std::vector<double>& times, const std::vector<double>& values, double time, double otherwise);

/// Names of inlets and outlets have to differ from each other.
void check_names_of_openings(const Case& whole, const CheckContext& at_table);

}  // namespace thalweg
