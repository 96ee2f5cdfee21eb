#include "foam_reference/gauges.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "common/error.hpp"
#include "common/extraction/gauges.hpp"
#include "common/profile.hpp"
#include "common/whole_file.hpp"
#include "foam_reference/column_sampler.hpp"
#include "foam_reference/dictionary.hpp"
#include "foam_reference/function_table.hpp"

namespace thalweg::foam {
namespace {

namespace fs = std::filesystem;

/// OpenFOAM's value of a place that lies in no cell is larger.
constexpr double no_cell = 1e200;

struct Probes {
  std::vector<std::string> fields;
  std::vector<Vec3> places;  // [m]
  bool between_cells;        // linear between the cells' values, or the value of the cell around the place
};

/// The column of cells around a place.
MeshPlan column_at(const MeshPlan& plan, const Vec3& place) {
  MeshPlan column = plan;
  const Vec3 size = plan.size();
  for (const int axis : {0, 1}) {
    const auto n = static_cast<double>(plan.cells[static_cast<std::size_t>(axis)]);
    const double cell = std::clamp(std::floor((place[axis] - plan.low[axis]) / size[axis]), 0.0, n - 1);
    column.low[axis] = plan.low[axis] + cell * size[axis];
    column.high[axis] = column.low[axis] + size[axis];
    column.cells[static_cast<std::size_t>(axis)] = 1;
  }
  return column;
}

std::vector<Vec3> centres_of(const MeshPlan& column) {
  std::vector<Vec3> centres;
  const Vec3 size = column.size();
  for (std::int64_t k = 0; k < column.cells[2]; ++k) {
    centres.emplace_back(column.low + Vec3(0.5, 0.5, 0.5 + static_cast<double>(k)).cwiseProduct(size));
  }
  return centres;
}

/// The gauge's place, moved in by a thousandth of a cell where it lies on the edge of the block.
Vec3 place_in(const FoamCase& foam_case, const Gauge& gauge) {
  const MeshPlan& plan = foam_case.plan;
  Vec3 place = gauge.at;
  if (foam_case.scene.info.dimension == 2) place.y() = (plan.low.y() + plan.high.y()) / 2;
  const Vec3 edge = 1e-3 * plan.size();
  return place.cwiseMax(plan.low + edge).cwiseMin(plan.high - edge);
}

/// Nothing for a flux.
Probes probes_of(const FoamCase& foam_case, const Gauge& gauge) {
  switch (gauge.kind) {
    case GaugeKind::pressure:
      return {{"p"}, {place_in(foam_case, gauge)}, true};
    case GaugeKind::velocity:
      return {{"U"}, {place_in(foam_case, gauge)}, true};
    case GaugeKind::water_level: {
      Probes probes{{}, centres_of(column_at(foam_case.plan, gauge.at)), false};
      probes.fields.emplace_back(foam_case.application() == "interFoam" ? "alpha.water" : "alpha.air");
      if (foam_case.has_eroding_bed()) probes.fields.emplace_back("bed");
      if (foam_case.has_sediment_phase()) probes.fields.emplace_back("alpha.sediment");
      return probes;
    }
    case GaugeKind::flux:
      break;
  }
  return {{}, {}, false};
}

std::string function_of(std::size_t gauge) { return fmt::format("gauge_{}", gauge + 1); }

/// Rows of time and values that OpenFOAM has recorded of a field.
using Records = std::vector<std::vector<double>>;

std::vector<Records> records_of(const fs::path& folder, std::size_t gauge, const Probes& probes) {
  std::vector<Records> records;
  for (const std::string& field : probes.fields) {
    records.push_back(read_table(folder / "case/postProcessing" / function_of(gauge) / "0" / field));
    if (records.back().size() == records.front().size()) continue;
    throw RunError(fmt::format("{}: its fields have different numbers of rows; run ./Allclean && ./Allrun in {}",
                               (folder / "case/postProcessing" / function_of(gauge)).string(),
                               (folder / "case").string()));
  }
  return records;
}

/// Levels out of the shares in a column of cells: of the water, and of the bed where there is one.
std::vector<double> levels(const FoamCase& foam_case, const Probes& probes, const std::vector<Records>& records,
                           std::size_t row) {
  std::vector<Vec3> centres;
  PhaseFields shares;
  const bool has_bed = records.size() > 1;
  for (std::size_t cell = 0; cell < probes.places.size(); ++cell) {
    const double share = records[0][row].at(cell + 1);
    if (std::abs(share) > no_cell) continue;
    centres.push_back(probes.places[cell]);
    shares.air.push_back(probes.fields[0] == "alpha.water" ? 1 - share : share);
    if (has_bed) shares.sediment.push_back(records[1][row].at(cell + 1));
  }
  std::vector<double> found(has_bed ? 2 : 1, Profile::missing);
  if (centres.empty()) return found;
  const ColumnSampler sampler(column_at(foam_case.plan, probes.places.front()), centres);
  const Profile profile = sampler.sample(shares).profile;
  found[0] = profile.free_surface.front();
  if (has_bed) found[1] = profile.bed.front();
  return found;
}

std::vector<double> values_of(const FoamCase& foam_case, const Gauge& gauge, const Probes& probes,
                              const std::vector<Records>& records, std::size_t row) {
  if (gauge.kind == GaugeKind::flux) {
    return std::vector<double>(foam_case.scene.has_sediment() ? 2 : 1, Profile::missing);
  }
  if (gauge.kind == GaugeKind::water_level) return levels(foam_case, probes, records, row);
  std::vector<double> found(records[0][row].begin() + 1, records[0][row].end());
  if (gauge.kind == GaugeKind::velocity && foam_case.scene.info.dimension == 2) found.erase(found.begin() + 1);
  if (std::abs(found.front()) > no_cell) std::ranges::fill(found, Profile::missing);
  return found;
}

}  // namespace

std::string gauge_functions(const FoamCase& foam_case) {
  const Output& output = foam_case.scene.output;
  const double interval = output.gauge_interval > 0 ? output.gauge_interval : output.end / 1000;
  std::string functions;
  for (std::size_t n = 0; n < foam_case.scene.gauges.size(); ++n) {
    const Probes probes = probes_of(foam_case, foam_case.scene.gauges[n]);
    if (probes.fields.empty()) continue;
    std::string places;
    for (const Vec3& place : probes.places) places += " " + vector(place);
    functions += substitute(R"(
    %function%  // gauge "%name%" of the case
    {
        type            probes;
        libs            ("libsampling.so");
        fields          (%fields%);
        probeLocations  (%places% );
        interpolationScheme %scheme%;
        writeControl    runTime;
        writeInterval   %interval%;
    }
)",
                            {{"function", function_of(n)},
                             {"name", foam_case.scene.gauges[n].name},
                             {"fields", fmt::format("{}", fmt::join(probes.fields, " "))},
                             {"places", places},
                             {"scheme", probes.between_cells ? "cellPoint" : "cell"},
                             {"interval", number(interval)}});
  }
  return functions;
}

void write_gauges(const FoamCase& foam_case, const fs::path& folder) {
  const Case& scene = foam_case.scene;
  if (scene.gauges.empty()) return;
  std::vector<Probes> probes;
  std::vector<std::vector<Records>> records;
  const Records* times = nullptr;
  for (std::size_t n = 0; n < scene.gauges.size(); ++n) {
    probes.push_back(probes_of(foam_case, scene.gauges[n]));
    records.push_back(records_of(folder, n, probes.back()));
  }
  for (const auto& of_gauge : records) {
    if (times == nullptr && !of_gauge.empty()) times = &of_gauge.front();
  }
  write_whole_text(folder / "gauges.csv", [&](std::ostream& to) {
    to << gauge_heading_line(scene) << '\n';
    for (std::size_t row = 0; times != nullptr && row < times->size(); ++row) {
      GaugeRow line;
      for (std::size_t n = 0; n < scene.gauges.size(); ++n) {
        const auto values = values_of(foam_case, scene.gauges[n], probes[n], records[n], row);
        if (std::isnan(values.front())) {
          const bool is_flux = scene.gauges[n].kind == GaugeKind::flux;
          line.notes.push_back(scene.gauges[n].name + (is_flux ? ": no flux on a mesh" : ": in a solid"));
        }
        line.values.insert(line.values.end(), values.begin(), values.end());
      }
      to << gauge_line((*times)[row].front(), line) << '\n';
    }
  });
}

}  // namespace thalweg::foam
