#include "gencase/hydrostatic.hpp"

#include <algorithm>
#include <cmath>

#include "physics/water/equation_of_state.hpp"

namespace thalweg::gencase {

double hydrostatic_density(double density_at_rest, double pressure, double sound_speed) {
  return density_at_rest * (1 + tait_excess(pressure, tait_stiffness(density_at_rest, sound_speed)));
}

HydrostaticStart::HydrostaticStart(const Filling& filling, const std::vector<PlacedShape>& shapes, double gravity)
    : filling_(filling), shapes_(shapes), gravity_(gravity), fluid_density_(std::size_t{solid_core} + 1, 0.0) {
  for (std::size_t s = 0; s < shapes.size(); ++s)
    if (shapes[s].is_fluid()) fluid_density_[s + 1] = shapes[s].weighing_density;
  find_runs();
  connect_runs();
}

Label HydrostaticStart::label(std::int64_t column, std::int64_t below_top) const {
  const std::int64_t length = filling_.lattice.column_length();
  const std::int64_t along = gravity_ > 0 ? below_top : length - 1 - below_top;
  return filling_.label[static_cast<std::size_t>(column * length + along)];
}

double HydrostaticStart::weight(std::int64_t column, std::int64_t below_top) const {
  return fluid_density_[label(column, below_top)] * std::abs(gravity_) * filling_.lattice.spacing;
}

double HydrostaticStart::weight_above_centre(const Run& run, std::int64_t node) const {
  double sum = 0.5 * weight(run.column, node);
  for (std::int64_t above = run.top; above < node; ++above) sum += weight(run.column, above);
  return sum;
}

void HydrostaticStart::find_runs() {
  const std::int64_t length = filling_.lattice.column_length();
  first_run_.push_back(0);
  for (std::int64_t column = 0; column < filling_.lattice.columns(); ++column) {
    for (std::int64_t node = 0; node < length; ++node) {
      if (!is_fluid(column, node)) continue;
      Run run{column, node, node};
      while (run.bottom + 1 < length && is_fluid(column, run.bottom + 1)) ++run.bottom;
      run.known = run.top == 0 || label(column, run.top - 1) == nothing;
      runs_.push_back(run);
      node = run.bottom;
    }
    first_run_.push_back(runs_.size());
  }
}

void HydrostaticStart::connect_runs() {
  std::deque<std::size_t> open;
  std::vector<std::size_t> covered;
  for (std::size_t r = 0; r < runs_.size(); ++r) {
    if (runs_[r].known)
      open.push_back(r);
    else
      covered.push_back(r);
  }
  spread(std::move(open));
  std::stable_sort(covered.begin(), covered.end(),
                   [&](std::size_t a, std::size_t b) { return runs_[a].top < runs_[b].top; });
  for (const std::size_t r : covered) {
    if (runs_[r].known) continue;
    runs_[r].known = true;  // the highest point of a fluid that is enclosed all around
    spread({r});
  }
}

void HydrostaticStart::spread(std::deque<std::size_t> known) {
  const Lattice& lattice = filling_.lattice;
  const std::int64_t slow_count = lattice.count[lattice.axes[0]];
  const std::int64_t middle_count = lattice.count[lattice.axes[1]];
  for (; !known.empty(); known.pop_front()) {
    const Run from = runs_[known.front()];
    const std::int64_t slow = from.column / middle_count;
    const std::int64_t middle = from.column % middle_count;
    const auto reach = [&](std::int64_t column) {
      for (std::size_t r = first_run_[column]; r < first_run_[column + 1]; ++r) {
        Run& to = runs_[r];
        const std::int64_t level = std::max(from.top, to.top);  // the highest node that both have
        if (to.known || level > std::min(from.bottom, to.bottom)) continue;
        const double pressure = from.surface_pressure + weight_above_centre(from, level);
        // Fluid above the free surface would start with a negative pressure, which a free-surface method cannot keep
        // up.
        to.surface_pressure = std::max(0.0, pressure - weight_above_centre(to, level));
        to.known = true;
        known.push_back(r);
      }
    };
    if (slow > 0) reach(from.column - middle_count);
    if (slow + 1 < slow_count) reach(from.column + middle_count);
    if (middle > 0) reach(from.column - 1);
    if (middle + 1 < middle_count) reach(from.column + 1);
  }
}

void HydrostaticStart::column(std::int64_t column, std::span<double> pressures) const {
  std::fill(pressures.begin(), pressures.end(), 0.0);
  for (std::size_t r = first_run_[column]; r < first_run_[column + 1]; ++r) {
    double above = runs_[r].surface_pressure;
    for (std::int64_t node = runs_[r].top; node <= runs_[r].bottom; ++node) {
      const double own = weight(column, node);
      const std::size_t along = gravity_ > 0 ? node : std::ssize(pressures) - 1 - node;
      pressures[along] = above + 0.5 * own;
      above += own;
    }
  }
}

double HydrostaticStart::fluid_height(const std::vector<ShapeRole>& roles) const {
  std::vector<bool> counts(fluid_density_.size());
  for (std::size_t s = 0; s < shapes_.size(); ++s)
    counts[s + 1] = std::find(roles.begin(), roles.end(), shapes_[s].shape->role) != roles.end();
  std::int64_t top = filling_.lattice.column_length();
  std::int64_t bottom = -1;
  for (const Run& run : runs_) {
    for (std::int64_t node = run.top; node <= run.bottom; ++node) {
      if (!counts[label(run.column, node)]) continue;
      top = std::min(top, node);
      bottom = std::max(bottom, node);
    }
  }
  return bottom < top ? 0 : static_cast<double>(bottom - top + 1) * filling_.lattice.spacing;
}

}  // namespace thalweg::gencase
