#include "foam_reference/open_patches.hpp"

#include "foam_reference/openings.hpp"

namespace thalweg::foam {

std::vector<std::string> open_patches(const FoamCase& foam_case) {
  std::vector<std::string> names;
  if (foam_case.plan.open(Face::open)) names.emplace_back("atmosphere");
  for (const OpeningPatch& patch : opening_patches(foam_case.scene)) names.push_back(patch.patch);
  return names;
}

std::string outflow_of(const std::string& phase, const std::string& patch) {
  return "outflow_" + phase + (patch == "atmosphere" ? "" : "_" + patch);
}

std::string wet_area_of(const std::string& patch) { return "wet_area_" + patch; }

}  // namespace thalweg::foam
