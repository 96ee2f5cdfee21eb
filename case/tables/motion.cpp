#include "case/tables/motion.hpp"

#include <algorithm>
#include <numbers>

#include "case/case.hpp"
#include "case/tables/common_checks.hpp"
#include "case/tables/time_table.hpp"
#include "common/csv.hpp"

namespace thalweg {
namespace {

/// The table that a kind of motion can follow: place or angle at given times.
enum class MotionTable { none, displacements, angles };

MotionTable table_of(MotionKind kind) {
  switch (kind) {
    case MotionKind::piecewise_linear:
      return MotionTable::displacements;
    case MotionKind::rotation:
      return MotionTable::angles;
    case MotionKind::gate_lift:
    case MotionKind::oscillation:
    case MotionKind::sliding_surface:
      return MotionTable::none;
  }
  return MotionTable::none;
}

void check_table(const CheckContext& at, const Motion& m, const std::string& column, const std::vector<double>& values,
                 const std::string& other_way) {
  if (!m.file.empty() && (!m.times.empty() || !values.empty())) {
    at.reject(at.key("file"), at.path() + " has a file and a table of its own", "choose one of the two");
  }
  if (!m.file.empty()) return;
  if (m.times.empty() && values.empty()) {
    at.reject(at.path(), at.path() + " does not say how far it goes",
              fmt::format("give times and {}, or a file{}", column, other_way));
  }
  check_table_over_time(at, column, m.times, values);
}

void check_rotation(const CheckContext& at, const Motion& m) {
  if (m.angular_speed != 0) {
    const bool by_table = !m.file.empty() || !m.times.empty() || !m.angles.empty();
    if (by_table) at.reject(at.path(), at.path() + " has an angular_speed and a table", "choose one of the two");
    return;
  }
  check_table(at, m, "angles", m.angles, ", or angular_speed");
  if (m.start > 0) {
    at.reject(at.key("start"), at.key("start") + " means nothing with a table", "begin the table later");
  }
}

// Values of a motion's table file: angles [rad] or displacements [m].
std::vector<double> angles_in(const CsvTable& table) {
  const auto& columns = table.columns();
  const bool degrees = std::any_of(columns.begin(), columns.end(), [](const CsvColumn& column) {
    return column.name == "angle" && column.unit == "deg";
  });
  std::vector<double> angles = table.numbers("angle", degrees ? "deg" : "rad");
  if (degrees) {
    for (double& angle : angles) angle *= std::numbers::pi / 180;
  }
  return angles;
}

}  // namespace

bool Motion::uses_key(std::string_view key, int dimension) const {
  if (key == "name" || key == "kind") return true;
  const MotionTable table = table_of(kind);
  if (key == "times" || key == "file") return table != MotionTable::none;
  if (key == "displacements") return table == MotionTable::displacements;
  if (key == "angles") return table == MotionTable::angles;
  if (key == "angular_speed" || key == "center") return kind == MotionKind::rotation;
  if (key == "axis") return kind == MotionKind::rotation && dimension == 3;
  if (key == "direction") return kind != MotionKind::rotation;
  if (key == "start") return kind != MotionKind::piecewise_linear;
  if (key == "distance") return kind == MotionKind::gate_lift;
  if (key == "speed" || key == "acceleration") {
    return kind == MotionKind::gate_lift || kind == MotionKind::sliding_surface;
  }
  return kind == MotionKind::oscillation;  // amplitude, period
}

std::vector<std::string> Motion::needs_keys(int dimension) const {
  switch (kind) {
    case MotionKind::piecewise_linear:
    case MotionKind::gate_lift:
    case MotionKind::sliding_surface:
      return {"direction"};
    case MotionKind::rotation:
      if (dimension == 2) return {"center"};
      return {"center", "axis"};
    case MotionKind::oscillation:
      return {"direction", "amplitude", "period"};
  }
  return {};
}

void Motion::check(const Case& whole, const CheckContext& at) const {
  check_word(at, "motion", name);
  check_keys(at, *this);
  const bool used = std::any_of(whole.shapes.begin(), whole.shapes.end(),
                                [&](const Shape& s) { return s.role == ShapeRole::moving_wall && s.motion == name; });
  if (!used) {
    at.reject(at.path(), at.path() + " moves no shape",
              "name it as `motion` of a shape with role = \"moving wall\", or remove it");
  }
  switch (kind) {
    case MotionKind::piecewise_linear:
      return check_table(at, *this, "displacements", displacements, "");
    case MotionKind::rotation:
      return check_rotation(at, *this);
    case MotionKind::gate_lift:
    case MotionKind::sliding_surface:
      if (speed > 0 || acceleration > 0) return;
      at.reject(at.path(), at.path() + " has neither speed nor acceleration", "give one of them");
    case MotionKind::oscillation:
      if (period > 0) return;
      at.reject(at.key("period"), at.key("period") + " is zero", "give the time of one to and fro");
  }
}

void Motion::read_files(const std::filesystem::path& folder) {
  if (file.empty()) return;
  const CsvTable table = CsvTable::read(folder / file);
  times = table.numbers("time", "s");
  switch (table_of(kind)) {
    case MotionTable::none:
      return;
    case MotionTable::displacements:
      displacements = table.numbers("displacement", "m");
      check_time_rows(table, times, displacements);
      break;
    case MotionTable::angles:
      angles = angles_in(table);
      check_time_rows(table, times, angles);
      break;
  }
  file.clear();
}

Motion Motion::without_defaults() {
  Motion motion;
  motion.direction = motion.center = motion.axis = Vec3::Constant(required);
  motion.amplitude = motion.period = required;
  return motion;
}

}  // namespace thalweg
