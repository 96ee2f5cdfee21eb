#include "solver/models/openings/make_openings.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "case/models/openings.hpp"
#include "physics/water/equation_of_state.hpp"
#include "solver/models/openings/inlet_columns.hpp"
#include "solver/models/openings/make_bed_feeds.hpp"
#include "solver/models/openings/make_grains_of_inlets.hpp"
#include "solver/models/openings/make_zone.hpp"
#include "solver/models/openings/waves_out.hpp"

namespace thalweg {
namespace {

/// One inlet with its columns.
struct InletWithColumns {
  Inlet inlet;
  std::size_t first = 0;  // of its columns, in the table of all
  std::size_t count = 0;
  double cell = 0;  // [m^2] cross-section of a column (2-D: [m])
};

class OpeningsOfCase final : public Openings {
 public:
  OpeningsOfCase(const Case& of, const std::optional<Vec3>& lattice_node)
      : dimension_(of.info.dimension),
        spacing_(of.numerics.spacing),
        density_(of.water.density),
        viscosity_(of.water.viscosity / of.water.density),
        gravity_(of.domain.gravity.norm()),
        stiffness_(tait_stiffness(of.water.density, of.numerics.sound_speed_factor * of.numerics.maximum_speed)),
        layers_(static_cast<int>(std::floor(zone_length(of) / of.numerics.spacing))),
        grains_of_inlets_(of),
        bed_feeds_(of),
        outlets_(of.outlets) {
    for (const Inlet& inlet : of.inlets) add(inlet, of, lattice_node);
    for (const Outlet& outlet : outlets_) {
      zones_.push_back(make_zone(outlet, of, lattice_node));
      names_.push_back(outlet.name);
    }
    for (std::vector<double>* of_zones :
         {&levels_, &takes_, &water_, &sediment_, &grains_, &depths_, &drying_, &waiting_grains_, &rates_, &means_}) {
      of_zones->resize(zones_.size());
    }
    waves_.resize(inlets_.size());
    bed_stresses_.assign(inlets_.size(), 0);
    speeds_.assign(columns_.size(), dry_column);
  }

  [[nodiscard]] const std::vector<Zone>& zones() const override { return zones_; }
  [[nodiscard]] const std::vector<double>& levels() const override { return levels_; }
  [[nodiscard]] const std::vector<double>& takes() const override { return takes_; }
  [[nodiscard]] const std::vector<float>& speeds() const override { return speeds_; }
  [[nodiscard]] const std::vector<double>& feeds() const override { return bed_feeds_.speeds(); }

  void fill(double time, const std::vector<WaterAtOpening>& waters, Population& population) override {
    for (std::size_t n = 0; n < zones_.size(); ++n) depths_[n] = waters[n].depth;
    set_levels(time);
    bed_feeds_.set_speeds(waters, sediment_, since_fill_);
    bed_feeds_.fill(population);
    let_waves_out(time, waters);
    set_returning();
    const std::vector<std::pair<std::size_t, std::size_t>> risen = choose_columns();
    set_areas();
    set_speeds(time);  // on which the grains of the newborn depend
    for (const auto& [inlet, column] : risen) {
      for (int layer = 0; layer < layers_; ++layer) bear(inlet, columns_[column], layer, population);
    }
    if (!water_of_pump_) water_of_pump_ = net_water();
    // Those that wait are let in with the lists that are made next.
    for (std::size_t n = 0; n < inlets_.size(); ++n) {
      grains_[n] += waiting_grains_[n], waiting_grains_[n] = 0;
    }
  }

  bool set_time(double time) override {
    const std::vector<float> before = speeds_;
    const std::vector<double> levels = levels_;
    const std::vector<double> takes = takes_;
    set_levels(time);
    set_speeds(time);
    return before != speeds_ || levels != levels_ || takes != takes_;
  }

  void set_bed_stress(std::size_t inlet, double stress) override { bed_stresses_[inlet] = stress; }

  void advance(double dt, Population& population) override {
    since_fill_ += dt;
    for (std::size_t n = 0; n < inlets_.size(); ++n) {
      const InletWithColumns& of = inlets_[n];
      sediment_[n] += bed_feeds_.advance(n, dt, population);
      for (std::size_t c = of.first; c < of.first + of.count; ++c) {
        InletColumn& column = columns_[c];
        if (!column.is_full) continue;
        column.phase += dt * double(speeds_[c]);
        while (column.phase >= spacing_) {
          column.phase -= spacing_;
          water_[n] += column.masses.front();
          column.masses.pop_front();
          bear(n, column, layers_ - 1, population);
        }
      }
    }
  }

  void count_out(std::size_t opening, double water, double sediment, double grains) override {
    const double dried = std::min(water, drying_[opening]);  // has never crossed the plane
    drying_[opening] -= dried;
    water_[opening] -= water - dried;
    sediment_[opening] -= sediment;
    grains_[opening] -= grains;
  }

  [[nodiscard]] std::vector<OpeningFlux> fluxes() const override {
    std::vector<OpeningFlux> fluxes;
    for (std::size_t n = 0; n < zones_.size(); ++n) {
      const Zone& zone = zones_[n];
      const double level = zone.at[2] - zone.half_up + depths_[n];
      const bool overflows = zone.upright && !zone.is_full && depths_[n] > 2 * zone.half_up + spacing_;
      fluxes.push_back({names_[n], water_[n], sediment_[n], grains_[n], zone.upright ? level : NAN, overflows});
    }
    return fluxes;
  }

  [[nodiscard]] std::vector<double> numbers() const override {
    std::vector<double> out{returning_, water_of_pump_.value_or(0), since_fill_};
    for (std::size_t n = 0; n < zones_.size(); ++n) {
      out.insert(out.end(),
                 {water_[n], sediment_[n], grains_[n], depths_[n], levels_[n], drying_[n], waiting_grains_[n]});
    }
    for (const WavesOut& waves : waves_)
      out.insert(out.end(), {waves.level, waves.height, waves.is_measured ? 1.0 : 0.0});
    for (const InletColumn& column : columns_) {
      out.insert(out.end(), {column.is_full ? 1.0 : 0.0, column.share, column.area, column.phase});
      for (std::size_t layer = 0; layer < static_cast<std::size_t>(layers_); ++layer) {
        out.push_back(column.is_full ? column.masses[layer] : 0);
      }
    }
    bed_feeds_.add_numbers(out);
    return out;
  }

  [[nodiscard]] bool restored(const std::vector<double>& numbers) override {
    constexpr std::size_t of_zone = 7;
    const std::size_t of_column = 4 + static_cast<std::size_t>(layers_);
    const std::size_t of_openings = 3 + of_zone * zones_.size() + 3 * waves_.size() + of_column * columns_.size();
    if (numbers.size() != of_openings + bed_feeds_.count_of_numbers()) return false;
    const double* next = numbers.data();
    returning_ = *next++;
    water_of_pump_ = *next++;
    since_fill_ = *next++;
    for (std::size_t n = 0; n < zones_.size(); ++n, next += of_zone) {
      water_[n] = next[0];
      sediment_[n] = next[1];
      grains_[n] = next[2];
      depths_[n] = next[3];
      levels_[n] = next[4];
      drying_[n] = next[5];
      waiting_grains_[n] = next[6];
    }
    for (WavesOut& waves : waves_) {
      waves.level = *next++;
      waves.height = *next++;
      waves.is_measured = *next++ != 0;
    }
    for (InletColumn& column : columns_) {
      column.is_full = *next++ != 0;
      column.share = *next++;
      column.area = *next++;
      column.phase = *next++;
      if (column.is_full) column.masses.assign(next, next + layers_);
      next += layers_;
    }
    bed_feeds_.restore(next);
    return true;
  }

 private:
  void add(const Inlet& inlet, const Case& of, const std::optional<Vec3>& lattice_node) {
    Zone zone = make_zone(inlet, of, lattice_node);
    zone.first_column = static_cast<Index>(columns_.size());
    const std::vector<InletColumn> columns = inlet_columns(zone, dimension_);
    const auto number = std::count_if(columns.begin(), columns.end(), [](const InletColumn& c) { return c.exists; });
    // The columns of a round opening share its area; their own squares would be up to a tenth more or less.
    const double cell = zone.round ? inlet.area(dimension_) / static_cast<double>(number)
                                   : 2 * zone.half_up / zone.rows * 2 * zone.half_across / zone.ranks;
    inlets_.push_back({inlet, columns_.size(), columns.size(), cell});
    columns_.insert(columns_.end(), columns.begin(), columns.end());
    zones_.push_back(zone);
    names_.push_back(inlet.name);
    bed_feeds_.add(inlet, zone);
  }

  /// z of the surface at each opening [m].
  void set_levels(double time) {
    for (std::size_t n = 0; n < zones_.size(); ++n) {
      const Zone& zone = zones_[n];
      const bool follows = zone.pumps || (n < inlets_.size() && inlets_[n].inlet.surface == InletSurface::follow);
      const Opening& opening =
          n < inlets_.size() ? static_cast<const Opening&>(inlets_[n].inlet) : outlets_[n - inlets_.size()];
      levels_[n] = follows ? zone.at[2] - zone.half_up + depths_[n] : opening.level_at(time);
    }
  }

  /// Measures the waves that come to the inlets.
  void let_waves_out(double time, const std::vector<WaterAtOpening>& waters) {
    for (std::size_t n = 0; n < inlets_.size(); ++n) {
      const Inlet& inlet = inlets_[n].inlet;
      if (!inlet.absorbs_waves || !(waters[n].depth > 0)) continue;
      const double asked = inlet.flow_rate_at(time, 0, dimension_) / inlet.extent_across(dimension_);
      waves_[n].measure(waters[n], asked, since_fill_, gravity_);
    }
    since_fill_ = 0;
  }

  /// Volume per time that enters through an inlet whose full columns have an area [m^2] (2-D: [m]).
  [[nodiscard]] double rate_of(std::size_t n, double time, double area) const {
    const Inlet& inlet = inlets_[n].inlet;
    const double asked = inlet.flow_rate_at(time, area, dimension_);
    const double width = inlet.extent_across(dimension_);
    return std::max(0.0, asked + width * waves_[n].discharge(asked / width, depths_[n], gravity_));
  }

  /// Depth of the water in an inlet [m].
  [[nodiscard]] double depth_in(std::size_t n) const {
    const Zone& zone = zones_[n];
    if (zone.is_full) return 2 * zone.half_up;
    return levels_[n] - (zone.at[2] - zone.half_up);
  }

  /// Level of the water in an inlet [rows over its lower edge].
  [[nodiscard]] double level_in_rows(std::size_t n) const {
    return depth_in(n) / (2 * zones_[n].half_up) * zones_[n].rows;
  }

  /// Marks the columns that are full. Returns those that have become so, as numbers of inlet and column.
  std::vector<std::pair<std::size_t, std::size_t>> choose_columns() {
    std::vector<std::pair<std::size_t, std::size_t>> risen;
    for (std::size_t n = 0; n < inlets_.size(); ++n) {
      const InletWithColumns& of = inlets_[n];
      const bool has_level = !zones_[n].is_full;
      const Index before = rows_with_water(columns_.data() + of.first, of.count, zones_[n].ranks);
      const Index rows = has_level ? rows_up_to(level_in_rows(n), before, zones_[n].rows) : zones_[n].rows;
      for (std::size_t c = of.first; c < of.first + of.count; ++c) {
        InletColumn& column = columns_[c];
        const auto row = static_cast<Index>(c - of.first) / zones_[n].ranks;
        const bool full = column.exists && row < rows;
        column.share = has_level && row == rows - 1 ? share_of_highest(level_in_rows(n), rows) : 1;
        if (full && !column.is_full) {
          column.phase = 0.5 * spacing_;
          risen.emplace_back(n, c);
        }
        if (!full && column.is_full) drying_[n] += column.mass();
        if (!full) column.masses.clear();
        column.is_full = full;
      }
    }
    return risen;
  }

  /// The discharge goes with the mass of the particles there are, whose share may have been another.
  void set_areas() {
    for (std::size_t n = 0; n < inlets_.size(); ++n) {
      const InletWithColumns& of = inlets_[n];
      for (std::size_t c = of.first; c < of.first + of.count; ++c) {
        InletColumn& column = columns_[c];
        const double z = zones_[n].at[2] + column.up * zones_[n].up[2] + column.across * zones_[n].across[2];
        column.set_area(of.cell, density_ * (1 + excess_at(n, z)) * spacing_);
      }
    }
  }

  /// Compression of an inlet's water at z [m].
  [[nodiscard]] double excess_at(std::size_t n, double z) const {
    const double head = zones_[n].is_full ? 0 : std::max(0.0, levels_[n] - z);
    return tait_excess(density_ * gravity_ * head, stiffness_);
  }

  /// The discharge as the inlet has it, spread over the columns that are full.
  void set_speeds(double time) {
    double entering = 0;
    for (std::size_t n = 0; n < inlets_.size(); ++n) {
      const InletWithColumns& of = inlets_[n];
      double area = 0;
      for (std::size_t c = of.first; c < of.first + of.count; ++c) area += columns_[c].area;
      const double rate = rate_of(n, time, area);
      const double mean = area > 0 ? rate / area : 0;
      rates_[n] = area > 0 ? rate : 0;
      means_[n] = mean;
      entering += rates_[n];
      double shaped = 0;
      std::vector<double> shape(of.count, 0.0);
      for (std::size_t c = 0; c < of.count; ++c) {
        const InletColumn& column = columns_[of.first + c];
        if (!column.is_full) continue;
        shape[c] = of.inlet.shape_at(column.up + zones_[n].half_up, column.across, depth_in(n), mean, viscosity_);
        shaped += shape[c] * column.area;
      }
      for (std::size_t c = 0; c < of.count; ++c) {
        const bool runs = columns_[of.first + c].is_full;
        speeds_[of.first + c] = runs ? static_cast<float>(shaped > 0 ? rate * shape[c] / shaped : 0) : dry_column;
      }
    }
    // A pump makes up for what it has taken too little or too much within some seconds.
    constexpr double time_of_pump = 2;  // [s]
    const double surplus = net_water() - water_of_pump_.value_or(net_water());
    const double taking = std::max(0.0, entering + surplus / (density_ * time_of_pump));
    for (std::size_t n = inlets_.size(); n < zones_.size(); ++n) takes_[n] = zones_[n].pumps ? taking : 0;
  }

  /// Water that has come in since the start, less what has gone out [kg].
  [[nodiscard]] double net_water() const {
    double net = 0;
    for (std::size_t n = 0; n < zones_.size(); ++n) net += water_[n];
    return net;
  }

  /// Grains that have left and not come back return within a second.
  void set_returning() {
    double gone = 0;
    for (std::size_t n = 0; n < zones_.size(); ++n) gone -= grains_[n] + waiting_grains_[n];
    constexpr double time = 1;  // [s]
    returning_ = grains_of_inlets_.density() > 0 ? std::max(0.0, gone) / grains_of_inlets_.density() / time : 0;
  }

  /// Volume share of the grains in a column.
  [[nodiscard]] double concentration_in(std::size_t n, const InletColumn& column) const {
    const Inlet& inlet = inlets_[n].inlet;
    if (inlet.grains == InletGrains::recirculated) return rates_[n] > 0 ? returning_ / rates_[n] : 0;
    return grains_of_inlets_.concentration(inlet, column.up + zones_[n].half_up, depth_in(n), means_[n],
                                           bed_stresses_[n]);
  }

  /// A particle of a column, `layer` spacings behind its first.
  void bear(std::size_t n, InletColumn& column, int layer, Population& population) {
    const Zone& zone = zones_[n];
    Newborn newborn;
    const double along = column.phase - (layer + 1) * spacing_;
    for (int c = 0; c < 3; ++c) {
      newborn.position.x[c] =
          zone.at[c] + along * zone.flow[c] + column.up * zone.up[c] + column.across * zone.across[c];
    }
    const double excess = excess_at(n, newborn.position.x[2]);
    newborn.excess = static_cast<float>(excess);
    const double volume = inlets_[n].cell * column.share * spacing_;
    newborn.mass = static_cast<float>(density_ * (1 + excess) * volume);
    newborn.role = Role::prescribed;
    const double concentration = concentration_in(n, column);
    newborn.grains = concentration * volume;
    population.bear(newborn);
    column.masses.push_back(double(newborn.mass));
    waiting_grains_[n] += newborn.grains * grains_of_inlets_.density();
  }

  int dimension_;
  double spacing_;    // [m]
  double density_;    // [kg/m^3]
  double viscosity_;  // [m^2/s]
  double gravity_;    // [m/s^2]
  double stiffness_;  // [Pa]
  int layers_;        // particles of a column
  GrainsOfInlets grains_of_inlets_;
  BedFeeds bed_feeds_;
  std::vector<Outlet> outlets_;
  std::vector<InletWithColumns> inlets_;
  std::vector<InletColumn> columns_;  // of all inlets
  std::vector<Zone> zones_;
  std::vector<double> levels_;  // [m]
  std::vector<std::string> names_;
  std::vector<float> speeds_;            // [m/s] of the columns
  std::vector<double> takes_;            // [m^3/s] of pumps (2-D: [m^2/s])
  std::vector<double> rates_;            // [m^3/s] of inlets (2-D: [m^2/s])
  std::vector<double> means_;            // [m/s] mean velocities of inlets
  std::vector<WavesOut> waves_;          // of inlets
  std::vector<double> bed_stresses_;     // [Pa] of inlets
  double since_fill_ = 0;                // [s] since columns were chosen
  std::optional<double> water_of_pump_;  // [kg] net_water() that a pump keeps
  double returning_ = 0;                 // [m^3/s] grains that come back (2-D: [m^2/s])
  std::vector<double> water_;            // [kg] that has come in, less what has gone out
  std::vector<double> sediment_;         // [kg]
  std::vector<double> grains_;           // [kg] that water carries
  std::vector<double> drying_;           // [kg] of inlets: columns that have fallen dry and have not been taken out yet
  std::vector<double> waiting_grains_;   // [kg]
  std::vector<double> depths_;           // [m] of the scene's water next to the openings
};

}  // namespace

std::shared_ptr<Openings> make_openings(const Case& of, const std::optional<Vec3>& lattice_node) {
  if (!models::OpenBoundaries::is_on(of)) return nullptr;
  return std::make_shared<OpeningsOfCase>(of, lattice_node);
}

}  // namespace thalweg
