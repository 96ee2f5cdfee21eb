// Allrun and Allclean: they repeat the run by hand, and thalweg-foam itself calls them.
#include "foam_reference/case_files.hpp"
#include "foam_reference/dictionary.hpp"
#include "foam_reference/surface_files.hpp"
#include "foam_reference/wall_patches.hpp"

namespace thalweg::foam {
namespace {

constexpr const char* run_template = R"(
cd "${0%%/*}" || exit 1

# The Debian package's programs find their dictionaries only through this variable.
export WM_PROJECT_DIR="${WM_PROJECT_DIR:-/usr/share/openfoam}"
%library%
# step NAME COMMAND...: output in log.NAME; the first failure ends the script.
step() {
    log="log.$1"
    shift
    echo "$log"
    "$@" > "$log" 2>&1 || { echo "failed: see $log" >&2; exit 1; }
}

step blockMesh blockMesh
%mesh%step writeCellCentres postProcess -func writeCellCentres -constant
step writeCellVolumes postProcess -func writeCellVolumes -constant
cp -r 0.orig 0 || exit 1
step setFields setFields
%solve%)";

constexpr const char* clean_template = R"(
cd "${0%%/*}" || exit 1
rm -rf 0 0.[0-9]* [1-9]* *e-[0-9]* processor[0-9]* postProcessing dynamicCode constant/polyMesh constant/triSurface log.*
rm -f constant/C constant/C[xyz] constant/V constant/cellLevel constant/cellMap constant/faceMap constant/pointMap
)";

}  // namespace

CaseFiles scripts(const FoamCase& foam_case) {
  const CaseFiles mesh = mesh_files(foam_case);
  std::string carve = surface_steps(foam_case);
  for (std::size_t i = 0; i < solid_roughnesses(foam_case).size(); ++i) {
    const std::string patch = solids_patch(i);
    carve += "step topoSet." + patch + " topoSet -dict system/topoSetDict." + patch + "\nstep subsetMesh" +
             (i > 0 ? "." + patch : "") + " subsetMesh flow -patch " + patch + " -overwrite\n";
  }
  if (mesh.contains("system/createPatchDict")) {
    carve +=
        "step topoSet.openings topoSet -dict system/topoSetDict.openings\n"
        "step createPatch createPatch -overwrite\n";
  }
  if (mesh.contains("system/topoSetDict.shapes")) {
    carve += "step topoSet.shapes topoSet -dict system/topoSetDict.shapes\n";
  }
  const std::string solver = foam_case.application();
  std::string solve = "step " + solver + " " + solver + "\n";
  if (foam_case.ranks > 1) {
    solve = R"script(# Open MPI refuses to run as root, as in most containers, unless told twice.
if [ "$(id -u)" = 0 ]; then export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1; fi
step decomposePar decomposePar
step )script" +
            solver + " mpirun --use-hwthread-cpus -np " + std::to_string(foam_case.ranks) + " " + solver +
            " -parallel\n"
            "step reconstructPar reconstructPar\n";
  }
  const std::string library =
      foam_case.library.empty()
          ? ""
          : "# Our models: foam_reference/library, built by tools/foam-library, which prints this folder.\n"
            "export LD_LIBRARY_PATH=\"" +
                foam_case.library.string() + "${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}\"\n";
  CaseFiles files;
  files["Allrun"] =
      "#!/bin/sh\n" +
      origin(foam_case.scene, "#", "Makes the mesh, fills it and runs it; ./Allclean first to start over.") +
      substitute(run_template, {{"", "%"}, {"library", library}, {"mesh", carve}, {"solve", solve}});
  files["Allclean"] = "#!/bin/sh\n" + origin(foam_case.scene, "#", "Removes all that Allrun makes.") +
                      substitute(clean_template, {{"", "%"}});
  return files;
}

}  // namespace thalweg::foam
