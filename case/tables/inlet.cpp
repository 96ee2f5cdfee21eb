#include "case/tables/inlet.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "case/case.hpp"
#include "case/models/openings.hpp"
#include "case/models/surface_bed.hpp"
#include "case/models/suspended_load.hpp"
#include "case/models/three_state.hpp"
#include "case/tables/common_checks.hpp"
#include "case/tables/time_table.hpp"
#include "common/csv.hpp"
#include "common/error.hpp"
#include "physics/transport/rouse.hpp"
#include "physics/water/log_profile.hpp"

namespace thalweg {
namespace {

/// The ways to say how much enters, each steady or as a table.
constexpr const char* steady_keys[] = {"velocity", "discharge", "flow_rate"};
constexpr const char* table_keys[] = {"velocities", "discharges", "flow_rates"};

void check_amount(const Inlet& inlet, const CheckContext& at) {
  int given = inlet.file.empty() ? 0 : 1;
  for (const char* key : steady_keys) given += at.given(key) ? 1 : 0;
  for (const char* key : table_keys) given += at.given(key) ? 1 : 0;
  if (given != 1) {
    at.reject(
        at.path(),
        given == 0 ? at.path() + " does not say how much enters" : at.path() + " says more than once how much enters",
        at.dimension() == 3 ? "give one of velocity, discharge, flow_rate, their tables, or a file"
                            : "give one of velocity, discharge, their tables, or a file");
  }
  for (const char* key : steady_keys) {
    const double value = inlet.velocity + inlet.discharge + inlet.flow_rate;
    if (at.given(key) && !(value > 0)) {
      at.reject(at.key(key), at.key(key) + " is 0: nothing enters", "give it a value, or remove the inlet");
    }
  }
  if (inlet.is_round() && (inlet.discharge > 0 || !inlet.discharges.empty())) {
    at.reject(at.key("diameter"), at.path() + " is round and has a discharge per width",
              "give its velocity or flow_rate");
  }
  if (!inlet.velocities.empty()) inlet.check_times(at, "velocities", inlet.velocities);
  if (!inlet.discharges.empty()) inlet.check_times(at, "discharges", inlet.discharges);
  if (!inlet.flow_rates.empty()) inlet.check_times(at, "flow_rates", inlet.flow_rates);
}

void check_increasing(const std::vector<double>& places, const std::string& key, const CheckContext& at) {
  if (std::adjacent_find(places.begin(), places.end(), std::greater_equal<>()) == places.end()) return;
  at.reject(at.key(key), at.key(key) + " do not increase", "sort them");
}

void check_section(const Inlet& inlet, const CheckContext& at) {
  const auto& [heights, across, speeds] = inlet.section;
  if (!inlet.profile_file.empty()) {
    if (heights.empty() && across.empty() && speeds.empty()) return;  // read_files() checks what stands in the file
    at.reject(at.key("profile_file"), at.path() + " says its profile twice", "give the file or the lists");
  }
  if (!across.empty() && speeds.size() != heights.size() * across.size()) {
    at.reject(at.key("speeds"),
              fmt::format("{} has {} heights, {} places across and {} speeds", at.path(), heights.size(), across.size(),
                          speeds.size()),
              "give one for each place across at the first height, at the second, and so on");
  }
  if (across.empty() && (heights.size() != speeds.size() || speeds.size() < 2)) {
    at.reject(at.key("speeds"),
              fmt::format("{} has {} heights and {} speeds", at.path(), heights.size(), speeds.size()),
              "give as many of both, two at least");
  }
  check_increasing(heights, "heights", at);
  check_increasing(across, "across", at);
  if (std::any_of(speeds.begin(), speeds.end(), [](double speed) { return speed > 0; })) return;
  at.reject(at.key("speeds"), at.key("speeds") + " are all 0", "give the speeds of the water");
}

void check_profile(const Inlet& inlet, const Case& whole, const CheckContext& at) {
  switch (inlet.profile) {
    case InletProfile::uniform:
      return;
    case InletProfile::log_law:
      if (std::abs(inlet.axes().flow.z()) > 1e-6) {
        at.reject(at.key("profile"), at.path() + " has a logarithmic profile and does not stand upright",
                  "write profile = \"uniform\", or let the direction be horizontal");
      }
      if (!(whole.water.viscosity > 0)) {
        at.reject(at.key("profile"), at.path() + " has a logarithmic profile, which needs the water's viscosity",
                  "give materials.water.viscosity");
      }
      return;
    case InletProfile::table:
      return check_section(inlet, at);
  }
}

void check_grains(const Inlet& inlet, const Case& whole, const CheckContext& at) {
  if (inlet.grains == InletGrains::none) return;
  if (!models::SuspendedLoadOfWater::is_on(whole)) {
    at.reject(at.key("grains"), at.path() + " brings grains, and no water carries any",
              "write carried_by = \"water\" in [suspended_load]");
  }
  if (inlet.uses_key("concentration", at.dimension()) && !(inlet.concentration > 0)) {
    at.reject(at.key("grains"), at.path() + " brings grains without a concentration",
              "give concentration, or write grains = \"none\"");
  }
  if (inlet.grains != InletGrains::rouse && inlet.grains != InletGrains::equilibrium) return;
  if (inlet.grains == InletGrains::rouse &&
      (!(inlet.reference_height > 0) || inlet.reference_height >= inlet.extent_up())) {
    at.reject(at.key("grains"), at.path() + " has Rouse's profile without a reference_height inside the opening",
              "give reference_height, such as a twentieth of the depth");
  }
  if (inlet.profile != InletProfile::log_law) {
    at.reject(at.key("grains"), at.path() + " has Rouse's profile, which belongs to a logarithmic one",
              "write profile = \"log-law\"");
  }
}

void check_bed_load(const Inlet& inlet, const Case& whole, const CheckContext& at) {
  if (inlet.bed_load == InletBedLoad::none) return;
  const std::string key = at.key("bed_load");
  if (models::SurfaceBedOfCase::is_on(whole)) {
    at.reject(key, at.path() + " brings bed load, which a bed that is a surface takes from surface_bed.feed",
              "give surface_bed.feed, and remove bed_load");
  }
  if (!models::ThreeState::is_on(whole) || whole.model.implementation != Implementation::law) {
    at.reject(key, at.path() + " brings bed load, and the bed carries none by a law",
              "write sediment = \"three-state\" in [model], without another implementation");
  }
  if (inlet.is_round() || std::abs(inlet.axes().flow.z()) > 1e-6) {
    at.reject(key, at.path() + " brings bed load and is no upright rectangle",
              "let its direction be horizontal, and give height and width");
  }
  if (inlet.bed_load == InletBedLoad::recirculated && whole.outlets.empty()) {
    at.reject(key, at.path() + " brings back what has left through the outlets, and there is none",
              "add an [[outlet]], or write bed_load = \"equilibrium\"");
  }
  if (inlet.bed_load != InletBedLoad::fixed) return;
  if (!(inlet.bed_load_rate > 0)) {
    at.reject(key, at.path() + " brings a fixed bed load without a rate",
              "give bed_load_rate, or write \"equilibrium\"");
  }
  const double layer = (1 - whole.sediment().porosity) * whole.numerics.spacing;
  const double fastest = largest_inlet_speed(inlet, whole);
  if (inlet.bed_load_rate > fastest * layer) {
    at.reject(
        at.key("bed_load_rate"),
        fmt::format("{} brings more bed load than a layer of one spacing carries that moves as fast as the water, "
                    "{:.3g} m^2/s",
                    at.path(), fastest * layer),
        "give less");
  }
}

bool has_table(const Inlet& inlet) {
  return !inlet.velocities.empty() || !inlet.discharges.empty() || !inlet.flow_rates.empty() || !inlet.levels.empty();
}

/// Ends the message "KEY means nothing ...".
std::string reason_against(const Inlet& inlet, const std::string& key, const CheckContext& at) {
  const bool of_space =
      key == "across" || key == "width" || key == "diameter" || key == "flow_rate" || key == "flow_rates";
  if (of_space && at.dimension() == 2) return "in the plane";
  if (key == "times") return "without a table of velocities, discharges, flow_rates or levels";
  if (key == "absorbs_waves") return fmt::format("with surface = \"{}\"", word_for(inlet.surface));
  if (key == "across" && inlet.profile == InletProfile::table) return "as it is empty";
  if (key == "roughness" || key == "heights" || key == "across" || key == "speeds" || key == "profile_file") {
    return fmt::format("with profile = \"{}\"", word_for(inlet.profile));
  }
  if (key == "concentration" || key == "reference_height") {
    return fmt::format("with grains = \"{}\"", word_for(inlet.grains));
  }
  if (key == "bed_load_rate") return fmt::format("with bed_load = \"{}\"", word_for(inlet.bed_load));
  if (key == "level" && inlet.surface == InletSurface::level) return "beside levels";
  if (key == "level" || key == "levels") return fmt::format("with surface = \"{}\"", word_for(inlet.surface));
  return "as it is empty or 0";
}

}  // namespace

bool Inlet::uses_key(std::string_view key, int dimension) const {
  if (is_place(key)) return uses_place(key, dimension);
  if ((key == "flow_rate" || key == "flow_rates") && dimension == 2) return false;
  // Of the ways to say how much enters the one that does; all while none does, for the message that one is missing.
  const bool lacks_amount = velocity + discharge + flow_rate == 0 && velocities.empty() && discharges.empty() &&
                            flow_rates.empty() && file.empty();
  if (key == "velocity") return velocity > 0 || lacks_amount;
  if (key == "discharge") return discharge > 0 || lacks_amount;
  if (key == "flow_rate") return flow_rate > 0 || lacks_amount;
  if (key == "velocities") return !velocities.empty();
  if (key == "discharges") return !discharges.empty();
  if (key == "flow_rates") return !flow_rates.empty();
  if (key == "file") return !file.empty();
  if (key == "concentration") return grains == InletGrains::uniform || grains == InletGrains::rouse;
  if (key == "reference_height") return grains == InletGrains::rouse;
  if (key == "bed_load_rate") return bed_load == InletBedLoad::fixed;
  if (key == "level") return surface == InletSurface::level && levels.empty();
  if (key == "levels") return surface == InletSurface::level && !levels.empty();
  if (key == "absorbs_waves") return surface == InletSurface::follow;
  if (key == "roughness") return profile == InletProfile::log_law;
  if (key == "heights" || key == "speeds") return profile == InletProfile::table;
  if (key == "across") return profile == InletProfile::table && dimension == 3 && !section.across.empty();
  if (key == "profile_file") return profile == InletProfile::table && !profile_file.empty();
  return key != "times" || has_table(*this);  // the rest: surface, profile
}

void Inlet::check(const Case& whole, const CheckContext& at_table) const {
  check_unused_keys(at_table, *this, [&](const std::string& key) { return reason_against(*this, key, at_table); });
  check_amount(*this, at_table);
  check_place(whole, at_table);
  if (!levels.empty()) check_times(at_table, "levels", levels);
  switch (surface) {
    case InletSurface::full:
      break;
    case InletSurface::level:
      if (!at_table.given("level") && levels.empty() && file.empty()) {
        at_table.reject(at_table.path(), at_table.path() + " does not say where its water stands",
                        "give level, or levels at times");
      }
      if (file.empty() || at_table.given("level")) check_levels(whole, at_table);
      break;
    case InletSurface::follow: {
      Inlet standing = *this;
      standing.level = standing.upper_edge();
      standing.levels.clear();
      standing.check_levels(whole, at_table);
      if (absorbs_waves && (velocity > 0 || !velocities.empty())) {
        at_table.reject(at_table.key("absorbs_waves"),
                        at_table.path() + " lets waves out and says how fast the water is, not how much enters",
                        "give the discharge or the flow_rate, or remove absorbs_waves");
      }
    }
  }
  check_profile(*this, whole, at_table);
  check_grains(*this, whole, at_table);
  check_bed_load(*this, whole, at_table);
}

void Inlet::read_files(const std::filesystem::path& folder) {
  if (!profile_file.empty()) read_profile(folder);
  if (!file.empty()) read_amounts(folder);
}

void Inlet::read_profile(const std::filesystem::path& folder) {
  section = read_velocity_section(folder / profile_file);
  const bool in_plane = extent_across(3) == 0;
  if (in_plane && !section.across.empty()) {
    throw InputError((folder / profile_file).string() + ": has the column across, and the case of inlet." + name +
                     " lies in the plane; remove the column, with one row for each height");
  }
  profile_file.clear();
}

void Inlet::read_amounts(const std::filesystem::path& folder) {
  const CsvTable table = CsvTable::read(folder / file);
  times = table.numbers("time", "s");
  if (table.has("flow_rate")) {
    flow_rates = table.numbers("flow_rate", "m^3/s");
    check_time_rows(table, times, flow_rates);
  } else if (table.has("discharge")) {
    discharges = table.numbers("discharge", "m^2/s");
    check_time_rows(table, times, discharges);
  } else {
    velocities = table.numbers("velocity", "m/s");
    check_time_rows(table, times, velocities);
    if (absorbs_waves) {
      throw InputError(table.where(0) + ": inlet." + name +
                       " lets waves out and the file says how fast the water is, not how much enters; give the column "
                       "discharge or flow_rate, or remove absorbs_waves");
    }
  }
  if (table.has("level")) {
    levels = table.numbers("level", "m");
    check_time_rows(table, times, levels);
    for (std::size_t row = 0; row < levels.size() && surface == InletSurface::level; ++row) {
      if (levels[row] > lower_edge() && levels[row] <= upper_edge() + 1e-12) continue;
      throw InputError(table.where(row) + ": the level does not lie in the opening of inlet." + name +
                       "; correct it, or make the opening higher");
    }
    if (surface != InletSurface::level) levels.clear();
  }
  file.clear();
}

Inlet Inlet::without_defaults() {
  Inlet inlet;
  inlet.at = inlet.direction = Vec3::Constant(required);
  return inlet;
}

double Inlet::flow_rate_at(double time, double wetted_area, int dimension) const {
  const double across = extent_across(dimension);
  if (flow_rate > 0 || !flow_rates.empty()) return value_at(times, flow_rates, time, flow_rate);
  if (discharge > 0 || !discharges.empty()) return across * value_at(times, discharges, time, discharge);
  return wetted_area * value_at(times, velocities, time, velocity);
}

double Inlet::shape_at(double height_over_edge, double place_across, double depth, double mean_velocity,
                       double viscosity) const {
  switch (profile) {
    case InletProfile::uniform:
      return 1;
    case InletProfile::log_law: {
      const double friction = friction_velocity_of_current(mean_velocity, depth, viscosity, roughness);
      return friction > 0 ? log_profile(friction, height_over_edge, viscosity, roughness) : 0;
    }
    case InletProfile::table:
      return section.speed_at(height_over_edge, place_across);
  }
  return 0;
}

double Inlet::concentration_at(double height_over_edge, double depth, double mean_velocity, double viscosity,
                               double settling_velocity) const {
  switch (grains) {
    case InletGrains::none:
    case InletGrains::equilibrium:
    case InletGrains::recirculated:
      return 0;
    case InletGrains::uniform:
      return concentration;
    case InletGrains::rouse: {
      const double friction = friction_velocity_of_current(mean_velocity, depth, viscosity, roughness);
      return concentration * rouse_share(height_over_edge, reference_height, depth, friction, settling_velocity);
    }
  }
  return 0;
}

}  // namespace thalweg
