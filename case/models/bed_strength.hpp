#pragma once

#include <array>

#include "case/tables/table.hpp"
#include "physics/sediment/drucker_prager.hpp"
#include "physics/sediment/effective_pressure.hpp"
#include "physics/sediment/mohr_coulomb.hpp"
#include "physics/sediment/mu_of_i.hpp"

// The words with which a case chooses the laws of the bed's strength.
namespace thalweg {

inline constexpr std::array<Choice<EffectivePressure>, 5> choices(EffectivePressure) {
  return {{{EffectivePressure::column, "column", "weight under water of the sediment above, column by column"},
           {EffectivePressure::laplace, "laplace", "Laplace's equation in the bed, one layer's weight at its surface"},
           {EffectivePressure::eos, "eos",
            "(1 - pore density / bed density) of the pressure: strength at the very surface; for comparison"},
           {EffectivePressure::total, "total",
            "the pressure of water and bed together, which the paper's print uses: the water's weight makes strength"},
           {EffectivePressure::grains, "grains",
            "seepage = \"mixture\", and its default: the grains' own pressure, less where water seeps upwards"}}};
}
inline constexpr std::array<Choice<YieldCriterion>, 2> choices(YieldCriterion) {
  return {{{YieldCriterion::drucker_prager, "drucker-prager", "a cone; yield_fit says which"},
           {YieldCriterion::mohr_coulomb, "mohr-coulomb", "Mohr-Coulomb by the Lode angle of the rate of strain"}}};
}
inline constexpr std::array<Choice<YieldFit>, 7> choices(YieldFit) {
  return {{{YieldFit::sine, "sin", "sin(phi): plane strain without dilation, for flumes and 2-D"},
           {YieldFit::coulomb, "coulomb", "tan(phi): slip along the shear plane; a slope stands up to phi"},
           {YieldFit::outer, "outer", "6 sin(phi) / (sqrt3 (3 - sin(phi))): outer cone of Mohr-Coulomb"},
           {YieldFit::inner, "inner", "6 sin(phi) / (sqrt3 (3 + sin(phi))): inner cone"},
           {YieldFit::plane_strain, "plane-strain",
            "3 tan(phi) / sqrt(9 + 12 tan^2(phi)): plane strain, dilation = friction"},
           {YieldFit::paper, "paper", "2 sin(phi) / (sqrt3 (3 - sin(phi))): the coefficient as the paper prints it"},
           {YieldFit::printed, "printed", "as paper, with the cohesion's 6 c sin(phi) that the paper misprints too"}}};
}
inline constexpr std::array<Choice<Rheology>, 2> choices(Rheology) {
  return {{{Rheology::herschel_bulkley, "herschel-bulkley", "yield stress, consistency and flow index"},
           {Rheology::mu_of_i, "mu-of-i", "friction that grows with the inertial number; consistency of the pores"}}};
}

}  // namespace thalweg
