#include "foam_reference/case_files.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "common/error.hpp"
#include "foam_reference/dictionary.hpp"
#include "foam_reference/openings.hpp"
#include "foam_reference/surface_files.hpp"

namespace thalweg::foam {
namespace {

// A time in whole microseconds, which are far below any step and have exact common divisors.
std::int64_t microseconds(double time) { return std::llround(time * 1e6); }

// A bed that is a phase has no law of the wall, and no model of eddies tells it from the water.
void check_model(const Case& scene, FoamModel model) {
  if (!scene.has_sediment() || model == FoamModel::eroding_bed) return;
  const bool is_current = has_current(scene);
  if (!is_current && scene.foam.turbulence != FoamTurbulence::k_omega) return;
  throw InputError(
      fmt::format("{}: the mesh model \"{}\" has no law of the wall over its bed, which {} needs; use foam.models = "
                  "[\"eroding-bed\"] "
                  "(--model eroding-bed), or run this case with --no-foam",
                  place(scene), name_of(model), is_current ? "a current" : "foam.turbulence = \"k-omega\""));
}

}  // namespace

FoamCase make_foam_case(const Case& scene, int ranks, FoamModel model, const std::filesystem::path& library) {
  check_model(scene, model);
  FoamCase foam_case;
  foam_case.scene = scene;
  foam_case.model = model;
  foam_case.library = library;
  foam_case.plan = plan_mesh(scene);
  foam_case.contents = measure_contents(scene, foam_case.plan);
  if (scene.has_sediment() && model == FoamModel::stock) foam_case.rheology = stock_rheology(scene, foam_case.contents);
  foam_case.ranks = ranks;
  return foam_case;
}

std::vector<std::string> phases(const FoamCase& foam_case) {
  if (foam_case.has_sediment_phase()) return {"water", "sediment", "air"};
  return {"water", "air"};
}

std::string columns_entries(const MeshPlan& plan, const std::string& indent) {
  const Vec3 size = plan.size();
  const auto periodic = [&](std::size_t axis) { return plan.faces[2 * axis] == Face::periodic ? "1" : "0"; };
  return indent + fmt::format("origin      ({} {});\n", number(plan.low.x()), number(plan.low.y())) + indent +
         fmt::format("size        ({} {});\n", number(size.x()), number(size.y())) + indent +
         fmt::format("count       ({} {});\n", plan.cells[0], plan.cells[1]) + indent +
         fmt::format("periodic    ({} {});\n", periodic(0), periodic(1));
}

double write_interval(const Case& scene) {
  const std::int64_t end = microseconds(scene.output.end);
  std::int64_t needed = end;
  for (const double time : scene.compare.times) {
    if (time > scene.output.end) {
      throw InputError(fmt::format("{}: compare.times holds {} s, after output.end = {} s; take it out or run longer",
                                   place(scene), number(time), number(scene.output.end)));
    }
    needed = std::gcd(needed, microseconds(time));
  }
  constexpr std::int64_t most_writes = 500;
  if (needed <= 0 || end / needed > most_writes) {
    throw InputError(fmt::format(
        "{}: output.end and compare.times share no interval above {} s; round them so that fields need not be written "
        "more than {} times",
        place(scene), number(scene.output.end / most_writes), most_writes));
  }
  // Fields at the snapshots' times too, so that both can be viewed beside each other.
  constexpr std::int64_t comfortable_writes = 100;
  const std::int64_t with_snapshots = std::gcd(needed, microseconds(scene.output.interval));
  return static_cast<double>(end / with_snapshots <= comfortable_writes ? with_snapshots : needed) * 1e-6;
}

CaseFiles case_files(const FoamCase& foam_case) {
  CaseFiles files;
  for (CaseFiles part :
       {mesh_files(foam_case), initial_fields(foam_case), model_files(foam_case), option_files(foam_case),
        surface_files(foam_case), control_files(foam_case), scripts(foam_case)}) {
    files.merge(part);
  }
  files["case.foam"] = "";  // for ParaView, which opens the folder through it
  return files;
}

}  // namespace thalweg::foam
