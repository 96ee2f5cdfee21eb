#include "case/tables/sediment.hpp"

#include "case/case.hpp"
#include "case/check_context.hpp"
#include "case/models/pore_pressure.hpp"
#include "case/models/surface_bed.hpp"
#include "case/models/three_state.hpp"
#include "case/tables/common_checks.hpp"
#include "case/tables/given_words.hpp"

namespace thalweg {

void SedimentTable::set_defaults(const GivenWords& given) {
  switch (given.choice<Implementation>("model.implementation").value_or(Implementation::law)) {
    case Implementation::law:
    case Implementation::consistent:
      return;
    case Implementation::paper:
      consistency = 1.54;  // [Pa s^n] 0.001 m^2/s times the paper's 1540 kg/m^3
      flow_index = 1.8;
      return;
  }
}

void SedimentTable::complete(const Case& whole) {
  if (whole.model.implementation == Implementation::paper && given_density == 0) given_density = grain_density;
}

void SedimentTable::check(const Case& whole, const CheckContext& at) const {
  check_word(at, "material", at.path().substr(at.path().find('.') + 1));
  if (dense_concentration < dilute_concentration) {
    at.reject(at.key("dense_concentration"), at.key("dense_concentration") + " is below dilute_concentration",
              "give at least as much, so that grains do not change to and fro");
  }
  const bool moves_by_law = models::ThreeState::is_on(whole) || models::SurfaceBedOfCase::is_on(whole);
  if (moves_by_law && !(grain_density > whole.water.density)) {
    at.reject(
        at.key("grain_density"),
        at.key("grain_density") + " is not above the water's density: grains that float have no threshold of motion",
        "give the grains' own density, without pores, or write model.sediment = \"viscoplastic\"");
  }
  if (suction > 0 && whole.model.effective_pressure != EffectivePressure::column) {
    at.reject(at.key("suction"), at.key("suction") + " adds to the effective pressure of the columns alone",
              "write effective_pressure = \"column\" in [model], or remove it");
  }
  if (critical_stress > 0 && critical_shields > 0) {
    at.reject(at.key("critical_stress"), at.key("critical_stress") + " and critical_shields say the same of the bed",
              "remove one of the two");
  }
  if (critical_porosity > 0 && !models::PorePressure::is_on(whole)) {
    at.reject(at.key("critical_porosity"),
              at.key("critical_porosity") + " means nothing without the pressure of the water in the pores",
              "write pore_pressure = \"diffusion\" in [model], or remove it");
  }
  switch (whole.model.rheology) {
    case Rheology::herschel_bulkley:
      return;
    case Rheology::mu_of_i:
      if (dynamic_friction_angle > friction_angle) return;
      at.reject(at.key("dynamic_friction_angle"),
                at.key("dynamic_friction_angle") + " is not above friction_angle, and rheology is \"mu-of-i\"",
                "give the friction angle of a fast flow, some 12 deg above");
  }
}

}  // namespace thalweg
