#pragma once

#include "case/models/rule.hpp"

namespace thalweg::models {

/// Sediment that stops where it is calm: model.rest, of a scene with sediment. It is off without gravity, which gives
/// the speed that counts as rest, and in a bed through which water seeps or whose pores drain, because such a bed is
/// never at rest.
struct Rest {
  static bool is_on(const Case& whole);
};

}  // namespace thalweg::models
