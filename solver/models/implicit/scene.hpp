#pragma once

#include "physics/water/viscosity_treatment.hpp"

namespace thalweg {

/// Parameters of the viscous part of a step.
template <int Dim>
struct ViscosityScene {
  ViscosityTreatment viscosity = ViscosityTreatment::implicit;
  double viscous_tolerance = 0;
  int viscous_iterations = 1000;
};

}  // namespace thalweg
