#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"
#include "common/app/scour/rows.hpp"

namespace thalweg {

/// A line on something in a case that cannot be read, and the option that tells it instead; without one it always holds.
struct SceneNote {
  std::string text;
  std::string option;  // the quantity's name
};

/// All that a case tells the formulas.
struct SceneReading {
  Inputs inputs;                       // of the flow and the bed
  std::vector<ScourSubject> subjects;  // with what is their own: widths, openings, diameters
  std::vector<SceneNote> notes;
};

/// Reads flow, bed and obstacles out of a case. Simple shapes count: boxes, cylinders, levels, layers, prisms in
/// 2-D and as sides of a flume. A depth is read where all water stands at one level, or an outlet holds one; a hydrograph counts with its
/// largest value.
SceneReading read_scene(const Case& scene);

/// The rows of all formulas for what a case shows; what is given counts before what the case tells. A row without its
/// inputs has no value.
std::vector<FormulaRow> formula_rows_of(const SceneReading& reading, const Inputs& given = {});

}  // namespace thalweg
