#include <cmath>

#include "common/error.hpp"
#include "physics/sediment/effective_pressure.hpp"
#include "physics/sediment/material.hpp"
#include "solver/models/all.hpp"
#include "solver/models/make.hpp"

namespace thalweg {

namespace {

void refuse_tilted_gravity(const Case& of) {
  const Vec3& g = of.domain.gravity;
  if (g.x() == 0 && g.y() == 0 && g.z() <= 0) return;
  throw InputError(of.file.string() +
                   ": domain.gravity: the sediment's effective pressure is the weight of what lies "
                   "above in z; let gravity point along -z or switch model.sediment off");
}

}  // namespace

template <int Dim>
void BedModel::make(const SceneSource& from, Scene<Dim>& scene) {
  if (!scene.has_sediment) return;
  const Case& of = from.of;
  refuse_tilted_gravity(of);
  const SedimentParameters& s = of.sediment();
  if (!scene.seepage.mixture) scene.sediment_density = static_cast<float>(s.bed_density());
  SedimentScene& law = scene.sediment;
  law = SedimentScene{make_material<float>(
      s, {of.model.yield, of.model.yield_fit, of.model.rheology, of.model.implementation == Implementation::paper})};
  law.effective_pressure = of.model.effective_pressure;
  const double gravity = -of.domain.gravity.z();
  law.submerged_weight = static_cast<float>(submerged_weight(s.bed_density(), s.pore_density, gravity));
  law.suction = static_cast<float>(s.suction);
  law.pore_stiffness = static_cast<float>(tait_stiffness(s.pore_density, from.sound_speed));
  const double submerged_density = s.bed_density() - s.pore_density;
  law.laplace_tolerance = static_cast<float>(1e-4 * submerged_density * from.sound_speed * from.sound_speed / 100);
}

template void BedModel::make(const SceneSource&, Scene<2>&);
template void BedModel::make(const SceneSource&, Scene<3>&);

}  // namespace thalweg
