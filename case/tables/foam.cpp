#include "case/tables/foam.hpp"

#include "case/models/turbulence.hpp"
#include "case/tables/common_checks.hpp"
#include "case/tables/given_words.hpp"

namespace thalweg {

void Foam::set_defaults(const GivenWords& given) {
  const auto of_particles = given.choice<Turbulence>("model.turbulence").value_or(Turbulence::mixing_length);
  if (given.has_lasting_current() && of_particles == Turbulence::mixing_length) turbulence = FoamTurbulence::k_omega;
}

void Foam::check(const Case&, const CheckContext& at) const {
  for (const std::string& model : models) {
    if (std::ranges::find(mesh_model_names, model) != mesh_model_names.end()) continue;
    at.reject("foam.models", fmt::format("foam.models holds \"{}\"", model),
              fmt::format("the mesh models are {}", fmt::join(mesh_model_names, ", ")));
  }
}

}  // namespace thalweg
