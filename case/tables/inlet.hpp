#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "case/tables/opening.hpp"
#include "case/tables/velocity_section.hpp"

namespace thalweg {

/// The words of inlet.surface.
enum class InletSurface { full, level, follow };

inline constexpr std::array<Choice<InletSurface>, 3> choices(InletSurface) {
  return {{{InletSurface::full, "full", "water fills the opening: a pipe, a sluice, a jet"},
           {InletSurface::level, "level", "water stands in the opening up to `level`"},
           {InletSurface::follow, "follow", "water stands in the opening as high as in the scene next to it"}}};
}

/// The words of inlet.profile.
enum class InletProfile { uniform, log_law, table };

inline constexpr std::array<Choice<InletProfile>, 3> choices(InletProfile) {
  return {
      {{InletProfile::uniform, "uniform", "the same velocity everywhere"},
       {InletProfile::log_law, "log-law", "the logarithmic profile over the opening's lower edge, with `roughness`"},
       {InletProfile::table, "table",
        "in proportion to `speeds` at `heights`, linear between; in space also `across`"}}};
}

/// The words of inlet.grains.
enum class InletGrains { none, uniform, rouse, equilibrium, recirculated };

inline constexpr std::array<Choice<InletGrains>, 5> choices(InletGrains) {
  return {{{InletGrains::none, "none", "the water is clear"},
           {InletGrains::uniform, "uniform", "it carries the same `concentration` everywhere"},
           {InletGrains::rouse, "rouse",
            "Rouse's profile over the opening's lower edge, with `concentration` at `reference_height`"},
           {InletGrains::equilibrium, "equilibrium",
            "Rouse's profile with as many as a bed of the case's sediment holds in suspension under this current"},
           {InletGrains::recirculated, "recirculated", "it brings the grains back that water has taken out"}}};
}

/// The words of inlet.bed_load.
enum class InletBedLoad { none, fixed, equilibrium, recirculated };

inline constexpr std::array<Choice<InletBedLoad>, 4> choices(InletBedLoad) {
  return {
      {{InletBedLoad::none, "none", "none comes in: a bed that moves is eaten away behind the inlet"},
       {InletBedLoad::fixed, "fixed", "as much as `bed_load_rate` says"},
       {InletBedLoad::equilibrium, "equilibrium", "as much as the bed carries four to ten spacings behind the inlet"},
       {InletBedLoad::recirculated, "recirculated", "what has left the scene through its outlets comes back"}}};
}

/// One [[inlet]]: an opening through which water enters.
struct Inlet : Opening {
  static constexpr TableHeading heading{
      "inlet", "Where water enters the scene: one such table for every opening (openings.md).",
      "An inlet holds particles ready in a zone upstream of its plane, as long as the neighbour lists reach and two "
      "spacings. They move with the velocity of the inlet and become water of the scene where they cross the plane."};

  double velocity = 0;             // [m/s]
  double discharge = 0;            // [m^2/s]
  double flow_rate = 0;            // [m^3/s]
  std::vector<double> velocities;  // [m/s]
  std::vector<double> discharges;  // [m^2/s]
  std::vector<double> flow_rates;  // [m^3/s]
  InletSurface surface = InletSurface::full;
  bool absorbs_waves = false;
  InletProfile profile = InletProfile::uniform;
  double roughness = 0;  // [m]
  VelocitySection section;
  std::string profile_file;
  InletGrains grains = InletGrains::none;
  double concentration = 0;     // [-]
  double reference_height = 0;  // [m]
  InletBedLoad bed_load = InletBedLoad::none;
  double bed_load_rate = 0;  // [m^2/s]

  template <class V>
  void describe(V& v) {
    describe_place(v, "Name of the inlet, unique among inlets and outlets; heads its columns in history.csv.");
    v.quantity("velocity", velocity, "m/s", 0, 100, "Mean velocity over the water in the opening.");
    v.quantity("discharge", discharge, "m^2/s", 0, 1000, "In place of it: volume per time and width.");
    v.quantity("flow_rate", flow_rate, "m^3/s", 0, 1e6, "In place of both, in space: volume per time.");
    v.quantities("times", times, "s", 0, 1e9, "A hydrograph: times of the table, increasing.");
    v.quantities("velocities", velocities, "m/s", 0, 100, "The velocity at `times`.");
    v.quantities("discharges", discharges, "m^2/s", 0, 1000, "In place of it: the discharge at `times`.");
    v.quantities("flow_rates", flow_rates, "m^3/s", 0, 1e6, "In place of both, in space: the flow rate at `times`.");
    v.quantities("levels", levels, "m", -1e6, 1e6, "surface = \"level\": the level at `times`.");
    v.text("file", file,
           "The table as CSV, relative to the case's folder: time [s], and velocity [m/s] or discharge [m^2/s] or "
           "flow_rate [m^3/s], and level [m] if it varies.");
    v.choice("surface", surface, "How much of the opening the water fills.");
    v.quantity("level", level, "m", -1e6, 1e6, "surface = \"level\": height z of the water's surface.");
    v.flag(
        "absorbs_waves", absorbs_waves,
        "surface = \"follow\": long waves that come to the inlet leave through it, and for as long it brings less or "
        "more than the discharge; else they are thrown back. Mesh models always throw them back.");
    v.choice("profile", profile, "How the velocity varies over the opening.");
    v.quantity("roughness", roughness, "m", 0, 1, "profile = \"log-law\": Nikuradse's roughness of the ground below.");
    v.quantities("heights", section.heights, "m", 0, 1e6,
                 "profile = \"table\": heights over the opening's lower edge.");
    v.quantities("across", section.across, "m", -1e6, 1e6,
                 "profile = \"table\", in space: places from the opening's middle to the left, as seen along the flow. "
                 "`speeds` has then one for each of them at the first height, at the second, and so on.");
    v.quantities("speeds", section.speeds, "m/s", 0, 1e3, "profile = \"table\": speeds there; their ratios count.");
    v.text("profile_file", profile_file,
           "In place of these three the table as CSV, relative to the case's folder: height [m], speed [m/s] and, in "
           "space, across [m]; rows in any order.");
    v.choice("grains", grains, "Grains that the water brings; it needs suspended_load.carried_by = \"water\".");
    v.number("concentration", concentration, 0, 0.3, "grains = \"uniform\", \"rouse\": volume share of the grains.");
    v.quantity("reference_height", reference_height, "m", 0, 1e3,
               "grains = \"rouse\": height over the lower edge at which the water has the concentration, and below.");
    v.choice("bed_load", bed_load,
             "Bed load that comes in below the water, onto a bed of particles that begins at the inlet's plane. The "
             "ground under the zone is a wall as high as the bed; its highest row of particles is the moving layer.");
    v.quantity("bed_load_rate", bed_load_rate, "m^2/s", 0, 10,
               "bed_load = \"fixed\": volume of the grains, without pores, per time and width.");
  }

  [[nodiscard]] bool uses_key(std::string_view key, int dimension) const;
  void check(const Case& whole, const CheckContext& at_table) const;
  /// The rows of the file become the table of the case, so that the resolved case holds them.
  void read_files(const std::filesystem::path& folder);
  static Inlet without_defaults();

  /// Volume per time [m^3/s] (2-D: [m^2/s]) at a time [s]; of `velocity` through a wetted area [m^2] (2-D: [m]).
  [[nodiscard]] double flow_rate_at(double time, double wetted_area, int dimension) const;
  /// Relative speed at a height over the lower edge [m] and a place across [m], under water of a depth [m] that flows
  /// with a mean velocity [m/s]; viscosity [m^2/s].
  [[nodiscard]] double shape_at(double height, double place_across, double depth, double mean_velocity,
                                double viscosity) const;
  /// Volume share of the grains there; settling velocity of one grain [m/s]. Not of those that come back, nor of a bed in equilibrium.
  [[nodiscard]] double concentration_at(double height, double depth, double mean_velocity, double viscosity,
                                        double settling_velocity) const;

 private:
  void read_profile(const std::filesystem::path& folder);
  void read_amounts(const std::filesystem::path& folder);
};

}  // namespace thalweg
