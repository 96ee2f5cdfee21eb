#pragma once

#include <string>

#include "case/case.hpp"
#include "common/particles.hpp"
#include "solver/program/run_output.hpp"
#include "solver/simulation/simulation.hpp"

namespace thalweg {

/// One line that says why a run has diverged: which particle, which quantity, when, and what to try.
std::string diagnose(const StepReport& report, const ParticleSet& particles, const Case& of, const RunClock& clock);

}  // namespace thalweg
