#pragma once

#include <array>
#include <iosfwd>

#include "case/tables/table.hpp"

namespace thalweg {

/// The words of model.implementation: two readings of the source paper (physics/sediment/sediment_parameters.hpp names
/// it).
enum class Implementation { consistent, paper };

inline constexpr std::array<Choice<Implementation>, 2> choices(Implementation) {
  return {{{Implementation::consistent, "consistent", "the physics the source paper means, misprints mended"},
           {Implementation::paper, "paper",
            "the equations as the source paper prints them; `thalweg explain sediment` tells the differences"}}};
}

/// Prints where the two readings of the three-state model differ.
void explain_implementations(std::ostream& to);

}  // namespace thalweg
