#pragma once

#include "case/case.hpp"
#include "common/particles.hpp"
#include "solver/simulation/input.hpp"

namespace thalweg {

class WaterBody;

/// The constants of a case as the passes use them. `particles` gives what depends on the filled scene: bounds, whether
/// there is sediment. Throws InputError for what the solver cannot run (sediment model with gravity that is not along
/// -z, a period shorter than the kernel's reach …). If `particles` are few of the scene (SceneDigest), `water` is that of all,
/// for driven flows.
AnyScene make_scene(const Case& from, const ParticleSet& particles, const WaterBody* water = nullptr);

}  // namespace thalweg
