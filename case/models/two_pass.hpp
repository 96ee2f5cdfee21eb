#pragma once

#include <array>
#include <vector>

#include "case/models/rule.hpp"

namespace thalweg {

/// The words of numerics.integrator.
enum class Integrator { leapfrog, two_pass };

inline constexpr std::array<Choice<Integrator>, 2> choices(Integrator) {
  return {{{Integrator::leapfrog, "leapfrog", "accelerations and density rates once a step, half a step apart"},
           {Integrator::two_pass, "two-pass", "the midpoint rule: both twice a step; for comparison"}}};
}

namespace models {

/// Time steps by the midpoint rule: numerics.integrator = "two-pass".
struct TwoPass {
  static bool is_on(const Case& whole);
  static std::vector<Rule> rules();
};

}  // namespace models

}  // namespace thalweg
