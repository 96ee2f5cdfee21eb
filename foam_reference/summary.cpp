#include "foam_reference/summary.hpp"

#include "case/reader/case_file.hpp"
#include "common/csv.hpp"
#include "common/version.hpp"

namespace thalweg::foam {
namespace {

namespace fs = std::filesystem;

class Summary {
 public:
  void row(const std::string& quantity, const std::string& value, const std::string& unit = "") {
    table_.add_row({quantity, value, unit});
  }
  void row(const std::string& quantity, double value, const std::string& unit) {
    row(quantity, csv_number(value), unit);
  }
  void count(const std::string& quantity, std::size_t value) { row(quantity, std::to_string(value), "-"); }
  void write(const fs::path& file) const { table_.write(file); }

 private:
  CsvTable table_{{{"quantity", ""}, {"value", ""}, {"unit", ""}}};
};

void write_rheology(Summary& summary, const StockRheology& rheology) {
  summary.row("viscosity_model", "HerschelBulkley (stock; yield stress without pressure)");
  summary.row("tau0", rheology.yield_stress, "Pa");
  summary.row("tau0_choice", "K p_eff + c_0 at the middle of the initial bed");
  summary.row("tau0_yield_coefficient", rheology.yield_coefficient, "-");
  summary.row("tau0_effective_pressure", rheology.effective_pressure, "Pa");
  summary.row("consistency", rheology.consistency, "Pa s^n");
  summary.row("flow_index", rheology.flow_index, "-");
  summary.row("viscosity_cap", rheology.viscosity_cap, "Pa s");
  summary.row("bed_density", rheology.density, "kg/m^3");
}

std::string source_of(BedLoad law) {
  switch (law) {
    case BedLoad::wong_parker:
      return "Wong & Parker 2006";
    case BedLoad::engelund_fredsoe:
      return "Engelund & Fredsoe 1976";
    case BedLoad::van_rijn:
      return "van Rijn 1984";
    case BedLoad::meyer_peter_mueller:
      break;
  }
  return "Meyer-Peter & Mueller 1948";
}

std::string source_of(PickUp law) {
  switch (law) {
    case PickUp::van_rijn:
      return "van Rijn 1984";
    case PickUp::mastbergen:
      break;
  }
  return "Mastbergen & van den Berg 2003";
}

std::string name_of(FoamTurbulence model) {
  switch (model) {
    case FoamTurbulence::smagorinsky:
      return "Smagorinsky";
    case FoamTurbulence::k_omega:
      return "k-omega";
    case FoamTurbulence::laminar:
      break;
  }
  return "laminar";
}

// Laws and constants of the sediment in the library's models, in the particle model's words.
void write_sediment(Summary& summary, const FoamCase& foam_case) {
  const Case& scene = foam_case.scene;
  const SedimentParameters& sediment = scene.sediment();
  if (foam_case.has_eroding_bed()) {
    summary.row("bed_load", source_of(scene.foam.bed_load));
    summary.row("pick_up", source_of(scene.foam.pick_up));
    summary.row("grain_diameter", sediment.grain_diameter, "m");
    summary.row("angle_of_repose", sediment.friction_angle, "rad");
    return;
  }
  const double coefficient = sediment_material(scene).yield_coefficient;
  const double deepest = coefficient * (sediment.bed_density() - sediment.pore_density) * -scene.domain.gravity.z() *
                         foam_case.contents.bed_thickness;
  summary.row("viscosity_model", "the particle model's (libthalwegFoam)");
  summary.row("yield_coefficient", coefficient, "-");
  summary.row("largest_viscosity", deepest * sediment.regularisation / 2 + sediment.consistency, "Pa s");
  summary.row("consistency", sediment.consistency, "Pa s^n");
  summary.row("flow_index", sediment.flow_index, "-");
  summary.row("bed_density", sediment.bed_density(), "kg/m^3");
}

std::string sentence_of(const FoamCase& foam_case) {
  const std::string turbulence = name_of(foam_case.scene.foam.turbulence);
  if (foam_case.has_eroding_bed()) return "interFoam over an eroding bed (libthalwegFoam; " + turbulence + ")";
  if (foam_case.scene.has_sediment() && needs_library(foam_case.scene, foam_case.model)) {
    return "multiphaseInterFoam, sediment by the particle model's laws (libthalwegFoam; " + turbulence + ")";
  }
  return foam_case.application() + " (stock OpenFOAM; " + turbulence + ")";
}

}  // namespace

std::string volume_unit(const FoamCase& foam_case) { return foam_case.scene.info.dimension == 2 ? "m^3/m" : "m^3"; }

void write_summary(const FoamCase& foam_case, const fs::path& file, const FoamRun& run, std::size_t cells,
                   const std::vector<VolumeBalance>& balances) {
  const std::string unit = volume_unit(foam_case);
  Summary summary;
  summary.row("case", foam_case.scene.info.name);
  summary.row("case_hash", hash_of(foam_case.scene));
  summary.row("code_version", version());
  summary.row("mesh_model", name_of(foam_case.model));
  summary.row("model", sentence_of(foam_case));
  summary.row("openfoam_version", run.openfoam_version);
  if (foam_case.rheology) write_rheology(summary, *foam_case.rheology);
  if (foam_case.scene.has_sediment() && needs_library(foam_case.scene, foam_case.model))
    write_sediment(summary, foam_case);
  summary.row("cell_size", foam_case.plan.cell, "m");
  summary.count("cells", cells);
  summary.count("ranks", static_cast<std::size_t>(foam_case.ranks));
  summary.count("steps", run.steps.size());
  summary.row("physical_time", foam_case.scene.output.end, "s");
  summary.row("cpu_seconds", run.cpu_seconds, "s");
  summary.row("wall_seconds", run.wall_seconds, "s");
  summary.row("water_volume_shapes", foam_case.contents.water_volume, unit);
  summary.row("sediment_volume_shapes", foam_case.contents.sediment_volume, unit);
  for (const VolumeBalance& balance : balances) {
    summary.row(balance.phase + "_volume_start", balance.start, unit);
    summary.row(balance.phase + "_volume_end", balance.end, unit);
    summary.row(balance.phase + "_outflow", balance.outflow, unit);
    summary.row(balance.phase + "_volume_error", balance.relative_error(), "-");
  }
  summary.row("continuity_error", run.steps.empty() ? 0 : run.steps.back().continuity_error, "-");
  summary.write(file);
}

}  // namespace thalweg::foam
