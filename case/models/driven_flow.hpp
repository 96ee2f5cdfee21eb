#pragma once

#include <vector>

#include "case/models/rule.hpp"

namespace thalweg {

/// Nikuradse's roughness [m] that a current of the case feels, for its start and its control: that of the sediment where
/// there is a bed, else the largest of the walls, 0 with smooth walls.
double roughness_of_current(const Case& of);

namespace models {

/// Water that is driven around a period: flow.drive.
struct DrivenFlow {
  static bool is_on(const Case& whole);
  static std::vector<Rule> rules();
};

}  // namespace models

}  // namespace thalweg
