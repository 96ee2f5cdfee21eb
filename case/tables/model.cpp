#include "case/tables/model.hpp"

#include <ostream>

#include "case/case.hpp"
#include "case/check_context.hpp"
#include "case/models/all.hpp"
#include "case/physics_checks.hpp"
#include "case/tables/given_words.hpp"

namespace thalweg {

void Model::set_defaults(const GivenWords& given) {
  if (given.choice<SeepageModel>("model.seepage") == SeepageModel::mixture) {
    effective_pressure = EffectivePressure::grains;
  }
  if (given.has_lasting_current()) {
    turbulence = Turbulence::mixing_length;
    wall_friction = WallFriction::smooth;
    bed_surface = SurfaceHold::held;
  }
  if (given.choice<SedimentModel>("model.sediment") == SedimentModel::surface) wall_friction = WallFriction::smooth;
  switch (given.choice<Implementation>("model.implementation").value_or(Implementation::law)) {
    case Implementation::law:
    case Implementation::consistent:
      return;
    case Implementation::paper:
      yield_fit = YieldFit::paper;
      bed_shear = BedShear::paper;
      effective_pressure = EffectivePressure::total;
      return;
  }
}

void Model::check(const Case& whole, const CheckContext& at) const {
  if (whole.has_sediment() && !models::SedimentMotion::is_on(whole)) {
    at.reject("model.sediment", "there is a sediment shape, and model.sediment is off",
              "write sediment = \"viscoplastic\" in [model]");
  }
  switch (yield) {
    case YieldCriterion::drucker_prager:
      break;
    case YieldCriterion::mohr_coulomb:
      if (at.resolved() || !at.given("yield_fit")) break;
      at.reject("model.yield_fit", "model.yield_fit means nothing with yield = \"mohr-coulomb\"", "remove it");
  }
  const bool moves_by_law = models::ThreeState::is_on(whole) && implementation == Implementation::law;
  if (!at.resolved() && at.given("bed_surface") && !moves_by_law) {
    at.reject("model.bed_surface", "model.bed_surface is of beds that move by laws",
              "remove it, or write sediment = \"three-state\" and implementation = \"law\"");
  }
  models::for_each_rule(whole, [&](const models::Rule& rule) {
    if (rule.broken(whole)) at.reject(rule.blamed, rule.what, rule.cure);
  });
  for (const PhysicsCheck& each : physics_checks())
    if (const std::string blamed = each.met(whole); !blamed.empty()) at.reject(blamed, each.cause, each.cure);
}

void Model::explain_further(std::ostream& to, std::string_view key) {
  if (key == "sediment" || key == "implementation") explain_implementations(to);
}

}  // namespace thalweg
