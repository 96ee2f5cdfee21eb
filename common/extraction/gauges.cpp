#include "common/extraction/gauges.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

#include "common/extraction/kernel_mean.hpp"
#include "common/extraction/profile_extraction.hpp"
#include "common/extraction/subset.hpp"

namespace thalweg {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string> names_of_values(const Gauge& gauge, const Case& of) {
  const bool space = of.info.dimension == 3;
  const bool sediment = of.has_sediment();
  switch (gauge.kind) {
    case GaugeKind::water_level:
      return sediment ? std::vector<std::string>{"level", "bed"} : std::vector<std::string>{"level"};
    case GaugeKind::pressure:
      return {"pressure"};
    case GaugeKind::velocity:
      return space ? std::vector<std::string>{"velocity_x", "velocity_y", "velocity_z"}
                   : std::vector<std::string>{"velocity_x", "velocity_z"};
    case GaugeKind::flux:
      return sediment ? std::vector<std::string>{"water", "sediment"} : std::vector<std::string>{"water"};
  }
  return {};
}

std::string unit_of_values(const Gauge& gauge, const Case& of) {
  switch (gauge.kind) {
    case GaugeKind::water_level:
      return "m";
    case GaugeKind::pressure:
      return "Pa";
    case GaugeKind::velocity:
      return "m/s";
    case GaugeKind::flux:
      return of.info.dimension == 3 ? "m^3/s" : "m^2/s";
  }
  return {};
}

// A curve at x: linear between columns, the nearer column's value where the other has none.
double at_column(const std::vector<double>& xs, const std::vector<double>& values, double x) {
  const auto right = std::lower_bound(xs.begin(), xs.end(), x);
  if (values.empty() || right == xs.end()) return nothing;
  const auto r = static_cast<std::size_t>(right - xs.begin());
  if (r == 0 || xs[r] == x) return values[r];
  const double share = (x - xs[r - 1]) / (xs[r] - xs[r - 1]);
  const double between = values[r - 1] + share * (values[r] - values[r - 1]);
  return std::isnan(between) ? values[share < 0.5 ? r - 1 : r] : between;
}

/// Half the width [m] of the surroundings in which a water level is looked for: bodies that meet within them count as
/// one, drops between them do not count.
double level_window(double spacing) { return 6 * spacing; }

/// Height of air [m] over which a gauge sees a sheet of water: a wave that runs over a dry bed may ride up to two
/// spacings above it.
double level_gap(double spacing) { return 3 * spacing; }

/// The direction in which a gauge's plane has no extent.
int normal_of(const Case& of, const Gauge& plane) {
  int normal = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const bool used = of.info.dimension == 3 || axis != 1;
    if (used && plane.from[axis] == plane.to[axis]) normal = axis;
  }
  return normal;
}

Eigen::AlignedBox3d region_of(const Case& of, const Gauge& gauge, const ParticleFileInfo& info) {
  const double reach = 2 * info.smoothing_length;
  Vec3 half = Vec3::Constant(reach);
  switch (gauge.kind) {
    case GaugeKind::pressure:
    case GaugeKind::velocity:
      break;
    case GaugeKind::water_level:
      half = Vec3(level_window(info.spacing) + reach + info.spacing, reach + info.spacing, HUGE_VAL);
      break;
    case GaugeKind::flux: {
      const Vec3 low = gauge.from.cwiseMin(gauge.to);
      const Vec3 high = gauge.from.cwiseMax(gauge.to);
      const Vec3 beyond = reach * Vec3::Unit(normal_of(of, gauge));
      Eigen::AlignedBox3d region(low - beyond, high + beyond);
      if (of.info.dimension == 2) region.min().y() = -HUGE_VAL, region.max().y() = HUGE_VAL;
      return region;
    }
  }
  return {gauge.at - half, gauge.at + half};
}

std::vector<double> water_level(const Case& of, const Gauge& gauge, const ParticleSet& particles) {
  const double window = level_window(particles.info.spacing);
  ExtractionSettings settings;
  settings.x_from = gauge.at.x() - window;
  settings.x_to = gauge.at.x() + window;
  settings.z_from = of.domain.from.z();
  settings.z_to = of.domain.to.z();
  settings.plane_y = gauge.at.y();
  settings.gap = level_gap(particles.info.spacing);
  settings.narrow_to_walls = false;
  const Eigen::AlignedBox3d region = region_of(of, gauge, particles.info);
  const ParticleSet around = subset(particles, [&](const Vec3& at) { return region.contains(at); });
  const Profile profile = extract_profile(around, settings).profile;
  std::vector<double> values{at_column(profile.x, profile.free_surface, gauge.at.x())};
  if (of.has_sediment()) values.push_back(at_column(profile.x, profile.bed, gauge.at.x()));
  return values;
}

/// Sums for the plane through weighted values: f(x) = c0 + c . (x - at)/h.
template <int Values>
class PlaneFit {
 public:
  void add(double weight, const Vec3& offset, const Eigen::Matrix<double, Values, 1>& value) {
    const Eigen::Vector4d basis(1, offset.x(), offset.y(), offset.z());
    moments_ += weight * basis * basis.transpose();
    sums_ += weight * basis * value.transpose();
  }

  [[nodiscard]] double weight() const { return moments_(0, 0); }

  /// The plane's values at its origin; the mean where the places do not span a plane.
  [[nodiscard]] Eigen::Matrix<double, Values, 1> value(int dimension) const {
    const std::vector<int> used = dimension == 2 ? std::vector{0, 1, 3} : std::vector{0, 1, 2, 3};
    const Eigen::MatrixXd moments = moments_(used, used) / weight();
    const Eigen::MatrixXd sums = sums_(used, Eigen::all) / weight();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> spread(moments, Eigen::EigenvaluesOnly);
    constexpr double least_spread = 1e-2;  // [-] a full neighbourhood has 0.16, one cut by a wall 0.05
    if (spread.eigenvalues().minCoeff() < least_spread) return sums.row(0).transpose();
    return moments.ldlt().solve(sums).row(0).transpose();
  }

 private:
  Eigen::Matrix4d moments_ = Eigen::Matrix4d::Zero();
  Eigen::Matrix<double, 4, Values> sums_ = Eigen::Matrix<double, 4, Values>::Zero();
};

/// Values of the fluid at the gauge's place; nothing without fluid there.
template <int Values, class Value>
std::optional<Eigen::Matrix<double, Values, 1>> fluid_value(const Case& of, const Gauge& gauge,
                                                            const ParticleSet& particles, Value&& value_of) {
  const bool water_only = of.model.seepage == SeepageModel::mixture;
  const double h = particles.info.smoothing_length;
  const KernelWeight weight(particles);
  const Eigen::AlignedBox3d region = region_of(of, gauge, particles.info);
  PlaneFit<Values> fit;
  for (std::size_t b = 0; b < particles.size(); ++b) {
    const bool counts = water_only ? particles.type[b] == ParticleType::water : is_fluid(particles.type[b]);
    if (!counts || !region.contains(particles.position[b])) continue;
    fit.add(weight(b, gauge.at), (particles.position[b] - gauge.at) / h, value_of(b));
  }
  constexpr double least_fluid = 0.1;  // [-] of the reach; on a wall or on the surface it is half
  if (!(fit.weight() > least_fluid)) return std::nullopt;
  return fit.value(particles.info.dimension);
}

std::vector<double> pressure(const Case& of, const Gauge& gauge, const ParticleSet& particles) {
  using One = Eigen::Matrix<double, 1, 1>;
  const auto found =
      fluid_value<1>(of, gauge, particles, [&](std::size_t b) { return One(double{particles.pressure[b]}); });
  return {found ? (*found)(0) : nothing};
}

std::vector<double> velocity(const Case& of, const Gauge& gauge, const ParticleSet& particles) {
  const auto found =
      fluid_value<3>(of, gauge, particles, [&](std::size_t b) { return Vec3(particles.velocity[b].cast<double>()); });
  const Vec3 u = found ? *found : Vec3::Constant(nothing);
  return of.info.dimension == 3 ? std::vector{u.x(), u.y(), u.z()} : std::vector{u.x(), u.z()};
}

std::vector<double> flux(const Case& of, const Gauge& gauge, const ParticleSet& particles) {
  const int normal = normal_of(of, gauge);
  const double reach = 2 * particles.info.smoothing_length;
  const Eigen::AlignedBox3d region = region_of(of, gauge, particles.info);
  double water = 0;
  double sediment = 0;
  for (std::size_t b = 0; b < particles.size(); ++b) {
    if (!is_fluid(particles.type[b]) || !region.contains(particles.position[b])) continue;
    const double distance = std::abs(particles.position[b][normal] - gauge.from[normal]);
    const double volume = double{particles.mass[b]} / double{particles.density[b]};
    const double passing = volume * double{particles.velocity[b][normal]} * (1 - distance / reach) / reach;
    (particles.type[b] == ParticleType::sediment ? sediment : water) += passing;
  }
  return of.has_sediment() ? std::vector{water, sediment} : std::vector{water};
}

std::vector<double> measure(const Case& of, const Gauge& gauge, const ParticleSet& particles) {
  switch (gauge.kind) {
    case GaugeKind::water_level:
      return water_level(of, gauge, particles);
    case GaugeKind::pressure:
      return pressure(of, gauge, particles);
    case GaugeKind::velocity:
      return velocity(of, gauge, particles);
    case GaugeKind::flux:
      return flux(of, gauge, particles);
  }
  return {};
}

}  // namespace

std::vector<CsvColumn> gauge_columns(const Case& of) {
  std::vector<CsvColumn> columns;
  for (const Gauge& gauge : of.gauges) {
    for (const std::string& value : names_of_values(gauge, of)) {
      columns.push_back({fmt::format("{}.{}", gauge.name, value), unit_of_values(gauge, of)});
    }
  }
  return columns;
}

std::string gauge_heading_line(const Case& of) {
  std::string line = CsvColumn{"time", "s"}.heading();
  for (const CsvColumn& column : gauge_columns(of)) line += "," + column.heading();
  return line + ",note";
}

std::string gauge_line(double time, const GaugeRow& row) {
  std::string line = csv_number(time);
  for (const double value : row.values) line += std::isnan(value) ? "," : fmt::format(",{:.7g}", value);
  return line + "," + fmt::format("{}", fmt::join(row.notes, "; "));
}

std::vector<Eigen::AlignedBox3d> gauge_regions(const Case& of, const ParticleFileInfo& info) {
  std::vector<Eigen::AlignedBox3d> regions;
  for (const Gauge& gauge : of.gauges) regions.push_back(region_of(of, gauge, info));
  return regions;
}

GaugeRow read_gauges(const Case& of, const ParticleSet& particles) {
  GaugeRow row;
  for (const Gauge& gauge : of.gauges) {
    const std::vector<double> values = measure(of, gauge, particles);
    if (std::isnan(values.front())) {
      row.notes.push_back(gauge.name + (gauge.kind == GaugeKind::water_level ? ": dry" : ": no fluid in reach"));
    }
    row.values.insert(row.values.end(), values.begin(), values.end());
  }
  return row;
}

}  // namespace thalweg
