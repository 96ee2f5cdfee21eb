#include "case/models/rest.hpp"

#include "case/case.hpp"

namespace thalweg::models {

bool Rest::is_on(const Case& whole) {
  return whole.model.rest && whole.domain.gravity.norm() > 0 && !Mixture::is_on(whole) && !PorePressure::is_on(whole);
}

}  // namespace thalweg::models
