// Makes profiles, history.csv and summary.csv from the fields and tables that OpenFOAM has written.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <sstream>

#include "common/csv.hpp"
#include "common/error.hpp"
#include "common/profile.hpp"
#include "foam_reference/bed_files.hpp"
#include "foam_reference/column_sampler.hpp"
#include "foam_reference/current_records.hpp"
#include "foam_reference/field_file.hpp"
#include "foam_reference/function_table.hpp"
#include "foam_reference/gauges.hpp"
#include "foam_reference/reference_run.hpp"
#include "foam_reference/summary.hpp"
#include "foam_reference/velocity_sampler.hpp"

namespace thalweg::foam {
namespace {

namespace fs = std::filesystem;

// The folder of a time's fields. OpenFOAM names it after the time, in a spelling of its own.
fs::path time_folder(const fs::path& case_folder, double time) {
  for (const fs::directory_entry& entry : fs::directory_iterator(case_folder)) {
    const std::string name = entry.path().filename().string();
    char* end = nullptr;
    const double value = std::strtod(name.c_str(), &end);
    if (end != name.c_str() && *end == '\0' && std::abs(value - time) < 1e-6) return entry.path();
  }
  throw RunError(fmt::format("{}: no fields at t = {:g} s; see the solver's log there", case_folder.string(), time));
}

std::vector<Vec3> cell_centres(const fs::path& case_folder) {
  const auto x = read_scalar_field(case_folder / "constant" / "Cx");
  const auto y = read_scalar_field(case_folder / "constant" / "Cy");
  const auto z = read_scalar_field(case_folder / "constant" / "Cz");
  std::vector<Vec3> centres(std::max({x.size(), y.size(), z.size()}));
  const auto at = [](const std::vector<double>& values, std::size_t i) { return values[values.size() == 1 ? 0 : i]; };
  for (std::size_t i = 0; i < centres.size(); ++i) centres[i] = Vec3(at(x, i), at(y, i), at(z, i));
  return centres;
}

double volume(const fs::path& field, const std::vector<double>& cell_volumes) {
  const std::vector<double> shares = read_scalar_field(field);
  if (shares.size() == 1) return shares.front() * std::accumulate(cell_volumes.begin(), cell_volumes.end(), 0.0);
  return std::inner_product(shares.begin(), shares.end(), cell_volumes.begin(), 0.0);
}

// Time, grains of the bed, in suspension and gone [m^3], lowest and highest bed [m]: the start, then every step.
constexpr std::size_t grain_columns = 6;
std::vector<std::vector<double>> read_grains(const fs::path& folder) {
  return read_table(folder / "case/postProcessing" / eroding_bed_name / "0/grains.dat");
}

VolumeBalance balance_of_grains(const fs::path& folder) {
  const auto rows = read_grains(folder);
  const auto held = [](const std::vector<double>& row) { return row.at(1) + row.at(2); };
  return {"grains", held(rows.front()), held(rows.back()), rows.back().at(3)};
}

void write_history(const FoamCase& foam_case, const fs::path& folder, const std::vector<SolverStep>& steps) {
  const auto volumes = read_table(folder / "case/postProcessing/volumes/0/volFieldValue.dat");
  if (volumes.size() != steps.size()) {
    throw RunError(fmt::format("{}: {} rows for {} steps; run ./Allclean && ./Allrun there",
                               (folder / "case/postProcessing/volumes").string(), volumes.size(), steps.size()));
  }
  std::vector<CsvColumn> columns{{"time", "s"}, {"dt", "s"}};
  for (const std::string& phase : phases(foam_case)) columns.push_back({phase, volume_unit(foam_case)});
  std::vector<std::vector<double>> grains;
  if (foam_case.has_eroding_bed()) {
    grains = read_grains(folder);
    grains.erase(grains.begin());  // the start
    grains.resize(steps.size(), std::vector<double>(grain_columns, Profile::missing));
    for (const char* name : {"bed_grains", "suspended_grains", "grains_left"}) {
      columns.push_back({name, volume_unit(foam_case)});
    }
  }
  std::vector<double> grains_left;
  for (const auto& row : grains) grains_left.push_back(row.at(3));
  const CurrentRecords current = current_records(foam_case, folder, steps, grains_left);
  columns.insert(columns.end(), current.columns.begin(), current.columns.end());
  columns.push_back({"continuity_error", "-"});
  CsvTable history(columns);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    std::vector<std::string> row{csv_number(steps[i].time), csv_number(steps[i].dt)};
    for (std::size_t phase = 1; phase < volumes[i].size(); ++phase) row.push_back(csv_number(volumes[i][phase]));
    if (!grains.empty()) {
      for (const std::size_t part : {1U, 2U, 3U}) row.push_back(csv_number(grains[i].at(part)));
    }
    for (const std::vector<double>& values : current.values) row.push_back(csv_number(values[i]));
    row.push_back(csv_number(steps[i].continuity_error));
    history.add_row(row);
  }
  history.write(folder / "history.csv");
}

// The eroding bed's columns at a time: x, y, floor, bed, thickness of the grains in suspension, and transport.
BedColumns read_bed(const fs::path& folder, double time) {
  BedColumns bed;
  const fs::path tables = time_folder(folder / "case/postProcessing" / eroding_bed_name, time);
  for (const auto& row : read_table(tables / "columns.dat")) {
    bed.x.push_back(row.at(0));
    bed.level.push_back(row.at(3));
    bed.suspended.push_back(row.at(4));
  }
  return bed;
}

// Shares of air and sediment in the cells at a time.
PhaseFields read_phases(const FoamCase& foam_case, const fs::path& fields) {
  PhaseFields shares;
  if (foam_case.has_sediment_phase()) shares.sediment = read_scalar_field(fields / "alpha.sediment");
  if (foam_case.application() == "multiphaseInterFoam") {
    shares.air = read_scalar_field(fields / "alpha.air");
  } else {
    shares.air = read_scalar_field(fields / "alpha.water");
    for (double& share : shares.air) share = 1 - share;
  }
  return shares;
}

// Water in the pores of the bed does not flow.
void exclude_bed(const std::vector<double>& bed, std::vector<double>& share) {
  const std::size_t cells = std::max(bed.size(), share.size());
  if (share.size() < cells) share.assign(cells, share.front());
  for (std::size_t cell = 0; cell < cells; ++cell) share[cell] *= 1 - bed[bed.size() == 1 ? 0 : cell];
}

// The times of the last half of the run at which fields were written.
std::vector<fs::path> late_fields(const fs::path& case_folder, double end) {
  std::vector<fs::path> folders;
  for (const fs::directory_entry& entry : fs::directory_iterator(case_folder)) {
    const std::string name = entry.path().filename().string();
    char* rest = nullptr;
    const double time = std::strtod(name.c_str(), &rest);
    if (rest != name.c_str() && *rest == '\0' && time > 0 && time >= 0.5 * end - 1e-6) folders.push_back(entry.path());
  }
  return folders;
}

// Velocities over the depth, where a current lasts.
void write_velocities(const FoamCase& foam_case, const fs::path& folder) {
  if (!foam_case.scene.has_lasting_current()) return;
  VelocitySampler sampler(foam_case, cell_centres(folder / "case"));
  for (const fs::path& fields : late_fields(folder / "case", foam_case.scene.output.end)) {
    WaterFields water{read_scalar_field(fields / "alpha.water"), read_vector_field(fields / "U")};
    if (foam_case.has_eroding_bed()) exclude_bed(read_scalar_field(fields / "bed"), water.share);
    sampler.add(water);
  }
  write_stations(folder / "stations.csv", sampler.stations());
}

}  // namespace

void write_profiles(const FoamCase& foam_case, const fs::path& folder) {
  const ColumnSampler sampler(foam_case.plan, cell_centres(folder / "case"));
  for (const double time : foam_case.scene.compare.times) {
    SampledProfile sampled = sampler.sample(read_phases(foam_case, time_folder(folder / "case", time)));
    if (foam_case.has_eroding_bed()) add_bed(sampled.profile, read_bed(folder, time));
    std::vector<std::string> comments{
        fmt::format("OpenFOAM {}, model {}, t = {:g} s, cells of {:g} m", foam_case.application(),
                    name_of(foam_case.model), time, foam_case.plan.size().x()),
        "elevations are column integrals of the phases' shares",
        fmt::format("the surface of equal shares (0.5) lies at most {:.2g} m from the free surface",
                    sampled.largest_free_surface_spread)};
    if (foam_case.has_sediment_phase()) {
      comments.back() += fmt::format(", {:.2g} m from the bed", sampled.largest_bed_spread);
    }
    if (foam_case.has_eroding_bed()) {
      comments.emplace_back("moving_bed: the packed bed; bed: with the grains in suspension above it, packed alike");
    }
    write_profile(folder / "profiles" / profile_file_name(time), sampled.profile, comments);
  }
}

std::vector<VolumeBalance> write_results(const FoamCase& foam_case, const fs::path& folder, const FoamRun& run) {
  const fs::path case_folder = folder / "case";
  const std::size_t cells = cell_centres(case_folder).size();
  std::vector<double> cell_volumes = read_scalar_field(case_folder / "constant" / "V");
  if (cell_volumes.size() == 1) cell_volumes.assign(cells, cell_volumes.front());
  const fs::path end_fields = time_folder(case_folder, foam_case.scene.output.end);

  std::vector<VolumeBalance> balances;
  for (const std::string& phase : phases(foam_case)) {
    if (phase == "air") continue;
    const auto volume_in = [&](const fs::path& fields) { return volume(fields / ("alpha." + phase), cell_volumes); };
    balances.push_back(
        {phase, volume_in(case_folder / "0"), volume_in(end_fields), outflow(foam_case, folder, phase, run.steps)});
  }
  if (foam_case.has_eroding_bed()) balances.push_back(balance_of_grains(folder));
  write_profiles(foam_case, folder);
  write_velocities(foam_case, folder);
  write_gauges(foam_case, folder);
  write_history(foam_case, folder, run.steps);
  write_summary(foam_case, folder / "summary.csv", run, cells, balances);
  return balances;
}

}  // namespace thalweg::foam
