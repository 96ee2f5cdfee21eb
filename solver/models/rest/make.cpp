#include <algorithm>
#include <cmath>

#include "case/models/rest.hpp"
#include "solver/models/all.hpp"
#include "solver/models/make.hpp"

namespace thalweg {

template <int Dim>
void RestModel::make(const SceneSource& from, Scene<Dim>& scene) {
  scene.may_rest = scene.has_sediment && models::Rest::is_on(from.of);
  if (!scene.may_rest) return;
  const SedimentParameters& s = from.of.sediment();
  const double g = from.of.domain.gravity.norm();
  const double dp = scene.spacing;
  RestCriteria& law = scene.rest;
  law.shear_rate = static_cast<float>(std::max(s.rest_shear / s.regularisation, s.rest_least_shear_rate));
  law.wake_shear_rate = static_cast<float>(s.wake_shear) * law.shear_rate;
  law.speed = static_cast<float>(s.rest_speed * std::sqrt(g * dp));
  law.time = static_cast<float>(s.rest_time * std::sqrt(dp / g));
}

template void RestModel::make(const SceneSource&, Scene<2>&);
template void RestModel::make(const SceneSource&, Scene<3>&);

}  // namespace thalweg
