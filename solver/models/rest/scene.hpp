#pragma once

namespace thalweg {

/// When sediment comes to rest and wakes again (models/rest).
struct RestCriteria {
  float shear_rate = 0;       // [1/s] below which sediment is calm: 98 % of the yield stress
  float wake_shear_rate = 0;  // [1/s] above which it wakes: 99.8 % of the yield stress
  float speed = 0;            // [m/s] below which sediment is calm
  float time = 0;             // [s] for which it has to be
};

/// Parameters of the model of resting deposits.
template <int Dim>
struct RestScene {
  bool may_rest = false;
  RestCriteria rest;
};

}  // namespace thalweg
