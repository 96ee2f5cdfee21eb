#include "case/tables/foam.hpp"

#include "case/tables/common_checks.hpp"

namespace thalweg {

void Foam::check(const Case&, const CheckContext& at) const {
  for (const std::string& model : models) {
    if (std::ranges::find(mesh_model_names, model) != mesh_model_names.end()) continue;
    at.reject("foam.models", fmt::format("foam.models holds \"{}\"", model),
              fmt::format("the mesh models are {}", fmt::join(mesh_model_names, ", ")));
  }
}

}  // namespace thalweg
