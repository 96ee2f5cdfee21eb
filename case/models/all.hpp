#pragma once

#include <tuple>

#include "case/models/driven_flow.hpp"
#include "case/models/mixture.hpp"
#include "case/models/moving_walls.hpp"
#include "case/models/openings.hpp"
#include "case/models/pore_pressure.hpp"
#include "case/models/rest.hpp"
#include "case/models/sediment_motion.hpp"
#include "case/models/shifting.hpp"
#include "case/models/surface_bed.hpp"
#include "case/models/suspended_load.hpp"
#include "case/models/thin_film.hpp"
#include "case/models/three_state.hpp"
#include "case/models/turbulence.hpp"
#include "case/models/wall_friction.hpp"

namespace thalweg::models {

/// Every optional model, in the order in which their rules are checked.
using All = std::tuple<MovingWalls, ThreeState, SedimentMotion, Mixture, PorePressure, Rest, DrivenFlow, OpenBoundaries,
                       WallStress, MixingLength, SubParticleStress, ParticleShifting, ThinFilms, SuspendedLoadOfWater,
                       SurfaceBedOfCase>;

/// Calls check(rule) for each rule of each model that is on.
template <class Check>
void for_each_rule(const Case& whole, Check&& check) {
  const auto rules_of = [&]<class Model>(Model) {
    if constexpr (requires { &Model::rules; }) {
      if (!Model::is_on(whole)) return;
      for (const Rule& rule : Model::rules()) check(rule);
    }
  };
  std::apply([&](auto... model) { (rules_of(model), ...); }, All{});
}

}  // namespace thalweg::models
