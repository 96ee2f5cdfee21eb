#include "solver/models/surface_bed/make_surface_bed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "case/models/grains.hpp"
#include "case/models/surface_bed.hpp"
#include "common/error.hpp"
#include "physics/bed/advance_bed.hpp"
#include "solver/models/surface_bed/make_bed_rows.hpp"
#include "solver/models/surface_bed/make_columns_beside.hpp"

namespace thalweg {
namespace {

/// Reads numbers one after the other.
class NumberReader {
 public:
  explicit NumberReader(const std::vector<double>& from) : from_(from) {}
  double next() { return at_ < from_.size() ? from_[at_++] : (failed_ = true, 0.0); }
  template <class T>
  void array(std::vector<T>& to, std::size_t size) {
    to.resize(size);
    for (T& value : to) value = static_cast<T>(next());
  }
  [[nodiscard]] bool failed() const { return failed_; }
  [[nodiscard]] std::size_t left() const { return from_.size() - at_; }

 private:
  const std::vector<double>& from_;
  std::size_t at_ = 0;
  bool failed_ = false;
};

class ColumnBed final : public SurfaceBed {
 public:
  explicit ColumnBed(const Case& of)
      : case_(of), grains_(grains_of(of)), spacing_(of.numerics.spacing), settings_(of.surface_bed) {
    const double speed = of.numerics.maximum_speed;
    longest_half_ = settings_.window > 0 ? 0.5 * settings_.window : 25 * spacing_ / speed;
    shortest_half_ = std::min(longest_half_, 2 * spacing_ / speed);
    half_window_ = longest_half_;
    lift_speed_ = 0.05 * speed;
  }

  void begin(LaidBed laid, double time) {
    bed_ = std::move(laid.columns);
    rows_ = std::move(laid.rows);
    for (int axis = 0; axis < 2; ++axis) first_[axis] = laid.first[axis];
    from_ = initial_ = levels();
    shear_.assign(from_.size(), 0);
    lifted_.assign(from_.size(), 0);
    find_inlets();
    gather_from(time);
    last_step_ = std::max(time, settings_.spin_up);
    show();
  }

  /// False where the numbers are not those of a bed.
  [[nodiscard]] bool restore(const std::vector<double>& numbers) {
    NumberReader in(numbers);
    const double version = in.next();
    bed_.grid.nx = static_cast<int>(in.next());
    bed_.grid.ny = static_cast<int>(in.next());
    if (version != version_of_numbers || bed_.grid.nx < 1 || bed_.grid.ny < 1) return false;
    bed_.grid.dx = in.next(), bed_.grid.dy = in.next();
    bed_.grid.periodic_x = in.next() != 0, bed_.grid.periodic_y = in.next() != 0;
    bed_.packing = in.next();
    first_[0] = in.next(), first_[1] = in.next();
    bed_.fed = in.next(), bed_.left = in.next(), bed_.lifted = in.next();
    is_moving_ = in.next() != 0;
    knows_half_ = in.next() != 0;
    halves_ = static_cast<int>(in.next());
    half_window_ = in.next(), due_ = in.next(), begin_ = in.next(), last_step_ = in.next();
    bed_time_ = in.next(), factor_ = in.next();
    steps_ = static_cast<std::int64_t>(in.next()), unsettled_ = static_cast<std::int64_t>(in.next());
    const auto columns = static_cast<std::size_t>(bed_.grid.nx) * static_cast<std::size_t>(bed_.grid.ny);
    if (in.left() != (arrays_of_numbers + numbers_of_sums) * columns + 1)
      return false;  // with the device's sums and a flag
    in.array(bed_.area, columns);
    in.array(bed_.floor, columns);
    in.array(bed_.ceiling, columns);
    in.array(bed_.grains, columns);
    std::vector<int> ends;
    in.array(ends, columns);
    for (const int end : ends) bed_.end.push_back(static_cast<BedEnd>(end));
    in.array(rows_, columns);
    in.array(from_, columns);
    in.array(initial_, columns);
    in.array(shear_, columns);
    in.array(lifted_, columns);
    half_.resize(columns);
    for (ColumnShear& of : half_) of.x = in.next(), of.y = in.next(), of.time = in.next();
    find_inlets();
    show();
    return !in.failed();
  }

  [[nodiscard]] std::vector<double> numbers() const override {
    std::vector<double> out = {version_of_numbers,
                               double(bed_.grid.nx),
                               double(bed_.grid.ny),
                               bed_.grid.dx,
                               bed_.grid.dy,
                               double(bed_.grid.periodic_x),
                               double(bed_.grid.periodic_y),
                               bed_.packing,
                               first_[0],
                               first_[1],
                               bed_.fed,
                               bed_.left,
                               bed_.lifted,
                               double(is_moving_),
                               double(knows_half_),
                               double(halves_),
                               half_window_,
                               due_,
                               begin_,
                               last_step_,
                               bed_time_,
                               factor_,
                               double(steps_),
                               double(unsettled_)};
    const auto add = [&](const auto& values) {
      for (const auto value : values) out.push_back(static_cast<double>(value));
    };
    add(bed_.area), add(bed_.floor), add(bed_.ceiling), add(bed_.grains), add(bed_.end);
    add(rows_), add(from_), add(initial_), add(shear_), add(lifted_);
    for (std::size_t c = 0; c < from_.size(); ++c) {
      const ColumnShear of = c < half_.size() ? half_[c] : ColumnShear{};
      out.insert(out.end(), {of.x, of.y, of.time});
    }
    return out;
  }

  [[nodiscard]] const std::vector<BedColumn>& columns() const override { return columns_; }
  [[nodiscard]] bool is_moving() const override { return is_moving_; }
  [[nodiscard]] double due() const override { return due_; }
  [[nodiscard]] double bed_time() const override { return bed_time_; }

  // From rest to rest, s = 3 x^2 - 2 x^3, so that the surface hits no water.
  [[nodiscard]] double share_at(double time) const override {
    const double x = is_moving_ ? std::clamp((time - begin_) / (due_ - begin_), 0.0, 1.0) : 1.0;
    return x * x * (3 - 2 * x);
  }
  [[nodiscard]] double rate_at(double time) const override {
    if (!is_moving_) return 0;
    const double x = std::clamp((time - begin_) / (due_ - begin_), 0.0, 1.0);
    return 6 * x * (1 - x) / (due_ - begin_);
  }

  void lift(const std::vector<double>& grains) override {
    for (std::size_t c = 0; c < grains.size(); ++c) lifted_[c] += grains[c];
  }

  void take(const std::vector<ColumnShear>& sums, double time) override {
    std::vector<ColumnShear> means = sums;
    for (ColumnShear& of : means) {
      if (of.time > 0) of.x /= of.time, of.y /= of.time;
    }
    if (time <= settings_.spin_up) {
      lifted_.assign(lifted_.size(), 0);
      for (std::size_t c = 0; c < means.size(); ++c) {
        shear_[c] = static_cast<float>(std::hypot(means[c].x, means[c].y));
      }
      gather_from(time);
      show();
      return;
    }
    ++halves_;
    const double change = knows_half_ ? change_between(half_, means) : std::numeric_limits<double>::infinity();
    const int most_halves = half_window_ < longest_half_ ? 2 : most_halves_of_window;
    if (change > settled_change && halves_ < most_halves) {
      half_ = std::move(means);
      knows_half_ = true;
      gather_on(time);
      return;
    }
    if (change > settled_change && half_window_ == longest_half_) ++unsettled_;
    move_under(means, time);
  }

  void arrive(double time) override {
    is_moving_ = false;
    from_ = levels();
    gather_from(time);
    show();
  }

  [[nodiscard]] double stress_at_inlet(std::size_t inlet) const override {
    double sum = 0;
    for (const int c : beside_inlets_[inlet]) sum += double(shear_[static_cast<std::size_t>(c)]);
    const std::size_t number = beside_inlets_[inlet].size();
    return number > 0 ? sum / static_cast<double>(number) : 0;
  }

  [[nodiscard]] BedReport report() const override {
    BedReport found;
    found.time = bed_time_;
    found.factor = factor_;
    found.grains = bed_.total();
    found.fed = bed_.fed;
    found.left = bed_.left;
    found.lifted = bed_.lifted;
    found.lowest = std::numeric_limits<double>::infinity();
    found.highest = -found.lowest;
    for (std::size_t c = 0; c < from_.size(); ++c) {
      if (!(bed_.area[c] > 0) || !(initial_[c] > bed_.floor[c])) continue;  // a floor that was bare from the start
      found.lowest = std::min(found.lowest, bed_.level(static_cast<int>(c)));
      found.highest = std::max(found.highest, bed_.level(static_cast<int>(c)));
      const double fall = initial_[c] - bed_.level(static_cast<int>(c));
      if (!(fall > found.scour)) continue;
      const auto in_row = static_cast<std::size_t>(bed_.grid.nx);
      const std::size_t row = c / in_row;
      found.scour = fall;
      found.scour_at[0] = first_[0] + static_cast<double>(c % in_row) * bed_.grid.dx;
      found.scour_at[1] = bed_.grid.ny == 1 ? 0 : first_[1] + static_cast<double>(row) * bed_.grid.dy;
    }
    found.steps = steps_;
    found.unsettled = unsettled_;
    return found;
  }

 private:
  static constexpr double version_of_numbers = 2;
  static constexpr std::size_t arrays_of_numbers = 13;  // of one number a column
  /// A window's stress has settled once its two halves differ by less, rms over the bed, of the rms stress [-].
  static constexpr double settled_change = 0.1;
  static constexpr int most_halves_of_window = 4;

  [[nodiscard]] std::vector<double> levels() const {
    std::vector<double> out;
    for (int c = 0; c < bed_.grid.columns(); ++c) out.push_back(bed_.level(c));
    return out;
  }

  /// The bed within ten spacings of an inlet, behind its first column, whose flow still feels the plane.
  void find_inlets() {
    for (const Inlet& inlet : case_.inlets) {
      std::vector<int> columns = columns_beside(inlet, case_, bed_.grid, first_, spacing_, 10 * spacing_);
      const auto is_solid = [&](int c) { return !(bed_.area[static_cast<std::size_t>(c)] > 0); };
      columns.erase(std::remove_if(columns.begin(), columns.end(), is_solid), columns.end());
      beside_inlets_.push_back(std::move(columns));
    }
  }

  void gather_from(double time) {
    knows_half_ = false;
    halves_ = 0;
    gather_on(time);
  }
  void gather_on(double time) { due_ = time + half_window_; }

  [[nodiscard]] static double change_between(const std::vector<ColumnShear>& before,
                                             const std::vector<ColumnShear>& now) {
    double change = 0;
    double size = 0;
    for (std::size_t c = 0; c < now.size(); ++c) {
      change += std::pow(now[c].x - before[c].x, 2) + std::pow(now[c].y - before[c].y, 2);
      size += std::pow(now[c].x, 2) + std::pow(now[c].y, 2);
    }
    return size > 0 ? std::sqrt(change / size) : 0;
  }

  /// The bed step: grains move under the mean of the last two halves.
  void move_under(const std::vector<ColumnShear>& means, double time) {
    std::vector<BedStress> stress(means.size());
    for (std::size_t c = 0; c < means.size(); ++c) {
      const double x = knows_half_ ? 0.5 * (means[c].x + half_[c].x) : means[c].x;
      const double y = knows_half_ ? 0.5 * (means[c].y + half_[c].y) : means[c].y;
      const double size = std::hypot(x, y);
      shear_[c] = static_cast<float>(size);
      if (!(size > 0)) continue;
      const double on_grains = settings_.grain_stress * size;
      stress[c] = bed_stress_of(grains_, std::sqrt(on_grains / grains_.water_density), x / size, y / size);
    }
    from_ = levels();
    const double elapsed = time - last_step_;
    std::vector<double> settling = std::move(lifted_);  // [m^3/s]
    for (double& of : settling) of /= -elapsed;
    lifted_.assign(settling.size(), 0);
    const BedAdvance done =
        advance_bed(bed_, grains_, stress, settling, settings_.factor * elapsed, settings_.step * spacing_);
    bed_time_ += done.time;
    factor_ = done.time / elapsed;
    // A bed that changes faster than its window lasts is followed with shorter ones: there is no mean to wait for.
    half_window_ = std::clamp(half_window_ * std::clamp(factor_, 0.5, 2.0), shortest_half_, longest_half_);
    last_step_ = time;
    ++steps_;
    is_moving_ = done.largest_change > 1e-9 * spacing_;
    if (is_moving_) {
      begin_ = time;
      due_ = time + 1.5 * done.largest_change / lift_speed_;  // its fastest is lift_speed_
    } else {
      from_ = levels();
      gather_from(time);
    }
    show();
  }

  /// The columns as the device sees them.
  void show() {
    columns_.resize(from_.size());
    for (int c = 0; c < bed_.grid.columns(); ++c) {
      const auto n = static_cast<std::size_t>(c);
      BedColumn& column = columns_[n];
      column.from = static_cast<float>(from_[n]);
      column.to = static_cast<float>(bed_.level(c));
      column.floor = static_cast<float>(bed_.floor[n]);
      column.slope[0] = static_cast<float>(slope_of_surface(c, 0));
      column.slope[1] = static_cast<float>(slope_of_surface(c, 1));
      column.shear = shear_[n];
      column.rows = rows_[n];
    }
  }

  /// Slope of the bed's surface, not up a step of the ground: a neighbour that stands higher or lower than grains can is
  /// left out.
  [[nodiscard]] double slope_of_surface(int c, int axis) const {
    double rise = 0;
    int steps = 0;
    for (const bool forward : {false, true}) {
      const int next = bed_.open_neighbour(c, axis, forward);
      if (next < 0) continue;
      const double slope = bed_.slope_between(c, axis, forward);
      if (std::abs(slope) > 1.5 * grains_.tan_friction) continue;
      rise += slope;
      ++steps;
    }
    return steps > 0 ? rise / steps : 0;
  }

  Case case_;
  Grains grains_;
  double spacing_;
  SurfaceBedSettings settings_;
  double longest_half_ = 0;   // [s] of a window
  double shortest_half_ = 0;  // [s]
  double half_window_ = 0;    // [s] of the one under way
  double lift_speed_ = 0;     // [m/s] with which the surface moves at most
  GrainColumns bed_;
  std::vector<float> rows_;
  double first_[2] = {};  // [m] middle of the first column
  std::vector<std::vector<int>> beside_inlets_;
  std::vector<double> initial_;    // [m] levels at the start
  std::vector<double> from_;       // [m] levels before the motion
  std::vector<float> shear_;       // [Pa]
  std::vector<double> lifted_;     // [m^3] grains that the water took since the last bed step
  std::vector<ColumnShear> half_;  // means of the window's last half; time: its length [s]
  std::vector<BedColumn> columns_;
  bool is_moving_ = false;
  bool knows_half_ = false;
  int halves_ = 0;        // of the window under way
  double begin_ = 0;      // [s] of the motion
  double due_ = 0;        // [s]
  double last_step_ = 0;  // [s]
  double bed_time_ = 0;   // [s]
  double factor_ = 0;     // [-]
  std::int64_t steps_ = 0;
  std::int64_t unsettled_ = 0;
};

}  // namespace

std::shared_ptr<SurfaceBed> make_surface_bed(const Case& of, ParticleSet& particles) {
  if (!models::SurfaceBedOfCase::is_on(of)) return nullptr;
  auto bed = std::make_shared<ColumnBed>(of);
  const auto known = particles.facts.find(surface_bed_fact);
  if (known == particles.facts.end()) {
    LaidBed laid = lay_bed(of, particles);
    bed->begin(std::move(laid), particles.info.time);
  } else if (!bed->restore(known->second)) {
    throw InputError("the checkpoint's field data " + std::string(surface_bed_fact) +
                     " is not that of a bed; start from a whole checkpoint of the same case");
  }
  return bed;
}

}  // namespace thalweg
