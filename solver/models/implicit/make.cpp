#include "solver/models/make.hpp"
#include "solver/models/all.hpp"

namespace thalweg {

template <int Dim>
void ViscosityModel::make(const SceneSource& from, Scene<Dim>& scene) {
  const Numerics& n = from.of.numerics;
  scene.viscosity = n.viscosity;
  scene.viscous_tolerance = n.viscous_tolerance;
  scene.viscous_iterations = n.viscous_iterations;
}

template void ViscosityModel::make(const SceneSource&, Scene<2>&);
template void ViscosityModel::make(const SceneSource&, Scene<3>&);

}  // namespace thalweg
