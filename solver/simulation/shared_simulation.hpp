#pragma once

#include <memory>

#include "solver/backend/ranks.hpp"
#include "solver/simulation/simulation.hpp"

// A simulation whose particles lie on several ranks. The first rank runs the program; what it asks of its simulation
// the others do as well, each with its share.
namespace thalweg {

/// On the first rank: a simulation that the others take part in until it is destroyed. `ranks` outlives it.
std::unique_ptr<Simulation> lead(std::unique_ptr<Simulation> share, Ranks& ranks);

/// On any other rank: does with its share what the first rank asks for, until that is done.
void follow(Simulation& share, Ranks& ranks);

}  // namespace thalweg
