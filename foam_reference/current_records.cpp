#include "foam_reference/current_records.hpp"

#include <algorithm>

#include "common/profile.hpp"
#include "foam_reference/current.hpp"
#include "foam_reference/function_table.hpp"
#include "foam_reference/open_patches.hpp"
#include "foam_reference/openings.hpp"

namespace thalweg::foam {
namespace {

namespace fs = std::filesystem;

// The last number of each row that a function of a patch has written, one for each step.
std::vector<double> at_patch(const fs::path& folder, const std::string& function, std::size_t steps) {
  const auto rows = read_table(folder / "case/postProcessing" / function / "0/surfaceFieldValue.dat");
  std::vector<double> values(steps, Profile::missing);
  for (std::size_t i = 0; i < std::min(rows.size(), steps); ++i) values[i] = rows[i].back();
  return values;
}

// Volume that has left through a patch by the end of each step.
std::vector<double> left_through(const fs::path& folder, const std::string& phase, const std::string& patch,
                                 const std::vector<SolverStep>& steps) {
  std::vector<double> sums = at_patch(folder, outflow_of(phase, patch), steps.size());
  double sum = 0;
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] = sum += sums[i] * steps[i].dt;
  return sums;
}

}  // namespace

CurrentRecords current_records(const FoamCase& foam_case, const fs::path& folder, const std::vector<SolverStep>& steps,
                               const std::vector<double>& grains_left) {
  const Case& scene = foam_case.scene;
  CurrentRecords records;
  const auto add = [&](const std::string& name, const std::string& unit, std::vector<double> values) {
    records.columns.push_back({name, unit});
    records.values.push_back(std::move(values));
  };
  for (const OpeningPatch& patch : opening_patches(scene)) {
    const std::string& name = patch.opening->name;
    std::vector<double> water = left_through(folder, "water", patch.patch, steps);
    for (double& mass : water) mass *= -scene.water.density;
    add(name + "_water", "kg", std::move(water));

    std::vector<double> sediment(steps.size(), 0.0);
    if (patch.outlet != nullptr && !grains_left.empty()) {
      const bool is_one = scene.outlets.size() == 1;
      for (std::size_t i = 0; i < sediment.size(); ++i) {
        sediment[i] = is_one ? -grains_left[i] * scene.sediment().grain_density : Profile::missing;
      }
    }
    add(name + "_sediment", "kg", std::move(sediment));

    std::vector<double> level = at_patch(folder, wet_area_of(patch.patch), steps.size());
    for (double& value : level) {
      value = is_upright(patch)
                  ? patch.opening->lower_edge() + value / patch.opening->extent_across(scene.info.dimension)
                  : Profile::missing;
    }
    add(name + "_level", "m", std::move(level));
  }
  if (scene.flow.drive == Drive::off) return records;
  const auto rows = read_table(folder / "case/postProcessing" / drive_name / "0/drive.dat");
  std::vector<double> velocity(steps.size(), Profile::missing);
  std::vector<double> drive(steps.size(), Profile::missing);
  for (std::size_t i = 0; i < std::min(rows.size(), steps.size()); ++i) {
    velocity[i] = rows[i].at(1);
    drive[i] = rows[i].at(2);
  }
  add("bulk_velocity", "m/s", std::move(velocity));
  add("drive", "m/s^2", std::move(drive));
  return records;
}

double outflow(const FoamCase& foam_case, const fs::path& folder, const std::string& phase,
               const std::vector<SolverStep>& steps) {
  double sum = 0;
  for (const std::string& patch : open_patches(foam_case)) {
    const std::vector<double> left = left_through(folder, phase, patch, steps);
    if (!left.empty()) sum += left.back();
  }
  return sum;
}

}  // namespace thalweg::foam
