#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "case/tables/table.hpp"

namespace thalweg {

/// A scene that cannot be, or that no law of the program covers. A case that matches it is refused.
struct PhysicsCheck {
  std::string scene;  // for the table in docs/refused-physics.md: "Grains twice as large as the bed is deep"
  std::string (*met)(const Case&);  // full name of the key or table to blame, as "domain.periodic"; empty: not met
  std::string cause;
  std::string cure;
};

/// Every such check, in the order in which they are made.
std::vector<PhysicsCheck> physics_checks();

/// Writes the page docs/refused-physics.md.
void write_physics_checks(std::ostream& to);

}  // namespace thalweg
