#pragma once

#include <array>
#include <iosfwd>

#include "case/tables/table.hpp"

namespace thalweg {

/// The words of model.implementation: ours, and two readings of the source paper
/// (physics/sediment/sediment_parameters.hpp names it).
enum class Implementation { law, consistent, paper };

inline constexpr std::array<Choice<Implementation>, 3> choices(Implementation) {
  return {{{Implementation::law, "law",
            "bed load moves at the rate of a measured law (model.bed_load), and the stress that moves it drags the "
            "water"},
           {Implementation::consistent, "consistent", "the physics the source paper means, misprints mended"},
           {Implementation::paper, "paper",
            "the equations as the source paper prints them; `thalweg explain sediment` tells the differences"}}};
}

/// Prints where the two readings of the three-state model differ.
void explain_implementations(std::ostream& to);

}  // namespace thalweg
