#include "foam_reference/column_sampler.hpp"

#include <algorithm>
#include <cmath>

namespace thalweg::foam {

struct ColumnSampler::Elevations {
  double integral = Profile::missing;  // [m]
  double crossing = Profile::missing;  // [m]
  double floor = Profile::missing;     // lower edge of the column's lowest cell
};

// The cells of a column from the floor up; -1 where there is no cell.
struct ColumnSampler::Column {
  std::vector<std::int64_t> cells;
  bool interrupted = false;  // a solid lies between cells
};

namespace {

double share_of(const std::vector<double>& shares, std::int64_t cell) {
  return shares.size() == 1 ? shares.front() : shares[static_cast<std::size_t>(cell)];
}

// Mean of the values that are not missing.
struct Mean {
  double sum = 0;
  int count = 0;
  void add(double value) {
    if (std::isnan(value)) return;
    sum += value;
    ++count;
  }
  [[nodiscard]] double value() const { return count > 0 ? sum / count : Profile::missing; }
};

}  // namespace

ColumnSampler::ColumnSampler(const MeshPlan& plan, const std::vector<Vec3>& centres) : plan_(plan) {
  cell_at_.assign(static_cast<std::size_t>(plan.cell_count()), -1);
  const Vec3 size = plan.size();
  for (std::size_t cell = 0; cell < centres.size(); ++cell) {
    const Vec3 index = (centres[cell] - plan.low).cwiseQuotient(size).array().floor();
    const auto position =
        static_cast<std::int64_t>(index.x()) +
        plan.cells[0] * (static_cast<std::int64_t>(index.y()) + plan.cells[1] * static_cast<std::int64_t>(index.z()));
    cell_at_.at(static_cast<std::size_t>(position)) = static_cast<std::int64_t>(cell);
  }
}

ColumnSampler::Elevations ColumnSampler::measure(const Column& column, const std::vector<double>& shares) const {
  const double dz = plan_.size().z();
  const auto present = [](std::int64_t cell) { return cell >= 0; };
  const auto lowest = std::ranges::find_if(column.cells, present) - column.cells.begin();
  const auto count = static_cast<std::ptrdiff_t>(column.cells.size());
  if (lowest == count) return {};
  const double floor = plan_.low.z() + static_cast<double>(lowest) * dz;

  Elevations elevations{floor, floor, floor};
  for (const std::int64_t cell : column.cells) {
    if (cell >= 0) elevations.integral += share_of(shares, cell) * dz;
  }
  for (std::ptrdiff_t k = count - 1; k >= 0; --k) {
    const std::int64_t cell = column.cells[static_cast<std::size_t>(k)];
    if (cell < 0 || share_of(shares, cell) < 0.5) continue;
    const double here = share_of(shares, cell);
    const std::int64_t above = k + 1 < count ? column.cells[static_cast<std::size_t>(k + 1)] : -1;
    const double centres_up = above < 0 ? 0.5 : (here - 0.5) / (here - share_of(shares, above));
    elevations.crossing = plan_.low.z() + (static_cast<double>(k) + 0.5 + centres_up) * dz;
    break;
  }
  if (column.interrupted) elevations.integral = elevations.crossing;
  return elevations;
}

void add_bed(Profile& profile, const BedColumns& bed) {
  const double half = profile.x.size() > 1 ? 0.5 * (profile.x[1] - profile.x[0]) : Profile::missing;
  std::vector<Mean> packed(profile.x.size());
  std::vector<Mean> top(profile.x.size());
  for (std::size_t column = 0; column < bed.x.size(); ++column) {
    const auto after = std::ranges::upper_bound(profile.x, bed.x[column] + half);
    if (after == profile.x.begin()) continue;
    const auto at = static_cast<std::size_t>(after - profile.x.begin()) - 1;
    packed[at].add(bed.level[column]);
    top[at].add(bed.level[column] + bed.suspended[column]);
  }
  for (std::size_t i = 0; i < profile.x.size(); ++i) {
    profile.moving_bed.push_back(packed[i].value());
    profile.bed.push_back(top[i].value());
    profile.free_surface[i] = std::max(profile.free_surface[i], top[i].value());
  }
}

SampledProfile ColumnSampler::sample(const PhaseFields& fields) const {
  std::vector<double> liquid(fields.air.size());
  std::ranges::transform(fields.air, liquid.begin(), [](double air) { return 1 - air; });

  SampledProfile sampled;
  for (std::int64_t i = 0; i < plan_.cells[0]; ++i) {
    Mean surface, surface_crossing, bed, bed_crossing, floor;
    for (std::int64_t j = 0; j < plan_.cells[1]; ++j) {
      Column column;
      int runs = 0;
      for (std::int64_t k = 0; k < plan_.cells[2]; ++k) {
        const std::int64_t cell = cell_at_[static_cast<std::size_t>(i + plan_.cells[0] * (j + plan_.cells[1] * k))];
        if (cell >= 0 && (column.cells.empty() || column.cells.back() < 0)) ++runs;
        column.cells.push_back(cell);
      }
      column.interrupted = runs > 1;
      const Elevations top = measure(column, liquid);
      surface.add(top.integral);
      surface_crossing.add(top.crossing);
      floor.add(top.floor);
      if (fields.sediment.empty()) continue;
      const Elevations sediment = measure(column, fields.sediment);
      bed.add(sediment.integral);
      bed_crossing.add(sediment.crossing);
    }
    sampled.profile.x.push_back(plan_.low.x() + (static_cast<double>(i) + 0.5) * plan_.size().x());
    sampled.profile.free_surface.push_back(surface.value());
    sampled.profile.floor.push_back(floor.value());
    const auto widen = [](double& largest, const Mean& a, const Mean& b) {
      if (a.count > 0) largest = std::max(largest, std::abs(a.value() - b.value()));
    };
    widen(sampled.largest_free_surface_spread, surface, surface_crossing);
    if (fields.sediment.empty()) continue;
    sampled.profile.bed.push_back(bed.value());
    widen(sampled.largest_bed_spread, bed, bed_crossing);
  }
  return sampled;
}

}  // namespace thalweg::foam
