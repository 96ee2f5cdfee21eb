#pragma once

#include "physics/sediment/drucker_prager.hpp"
#include "physics/sediment/effective_pressure.hpp"
#include "physics/sediment/mohr_coulomb.hpp"
#include "physics/sediment/mu_of_i.hpp"
#include "physics/transport/bed_load.hpp"
#include "physics/transport/pick_up.hpp"
#include "physics/transport/slope_effect.hpp"

// The words for choices of the particle model in the dictionaries of an OpenFOAM case. thalweg-foam writes them and
// libthalwegFoam reads them. C++17.
namespace thalweg::foam {

inline const char* dictionary_word(EffectivePressure choice) {
  switch (choice) {
    case EffectivePressure::laplace:
      return "laplace";
    case EffectivePressure::eos:
      return "eos";
    case EffectivePressure::total:
      return "total";
    case EffectivePressure::column:
    case EffectivePressure::grains:  // of a mixture, which the mesh does not have
      break;
  }
  return "column";
}

inline const char* dictionary_word(YieldCriterion choice) {
  switch (choice) {
    case YieldCriterion::mohr_coulomb:
      return "mohrCoulomb";
    case YieldCriterion::drucker_prager:
      break;
  }
  return "druckerPrager";
}

inline const char* dictionary_word(YieldFit choice) {
  switch (choice) {
    case YieldFit::coulomb:
      return "coulomb";
    case YieldFit::outer:
      return "outer";
    case YieldFit::inner:
      return "inner";
    case YieldFit::plane_strain:
      return "planeStrain";
    case YieldFit::paper:
      return "paper";
    case YieldFit::printed:
      return "printed";
    case YieldFit::sine:
      break;
  }
  return "sin";
}

inline const char* dictionary_word(Rheology choice) {
  switch (choice) {
    case Rheology::mu_of_i:
      return "muOfI";
    case Rheology::herschel_bulkley:
      break;
  }
  return "herschelBulkley";
}

inline const char* dictionary_word(BedLoad choice) {
  switch (choice) {
    case BedLoad::wong_parker:
      return "wongParker";
    case BedLoad::engelund_fredsoe:
      return "engelundFredsoe";
    case BedLoad::van_rijn:
      return "vanRijn";
    case BedLoad::meyer_peter_mueller:
      break;
  }
  return "meyerPeterMueller";
}

inline const char* dictionary_word(SlopeEffect choice) {
  switch (choice) {
    case SlopeEffect::threshold:
      return "threshold";
    case SlopeEffect::friction:
      break;
  }
  return "friction";
}

inline const char* dictionary_word(PickUp choice) {
  switch (choice) {
    case PickUp::van_rijn:
      return "vanRijn";
    case PickUp::mastbergen:
      break;
  }
  return "mastbergen";
}

}  // namespace thalweg::foam
