#pragma once

#include <string>
#include <vector>

#include "case/models/rule.hpp"

namespace thalweg::models {

/// The needs of a model in which the water of the pores moves: a bed with pores full of the scene's water, and wide
/// enough for Ergun's law. `key` is the full name of the key that switches the model on.
std::vector<Rule> pore_water_rules(const std::string& key);

}  // namespace thalweg::models
