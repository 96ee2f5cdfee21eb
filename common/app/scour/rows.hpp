#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/app/scour/quantities.hpp"
#include "physics/scour/hec18_pier.hpp"
#include "physics/scour/limits.hpp"

namespace thalweg {

/// Kinds of scour that there are formulas for.
enum class ScourKind { pier, pipe, contraction, wall_jet, plunge_pool, bed_protection };

/// Something in the scene, or given by options, that the water scours at.
struct ScourSubject {
  ScourKind kind = ScourKind::pier;
  std::string title;  // "pier \"pile\""
  PierNose nose = PierNose::circular;
  Inputs inputs;
};

/// An input as a formula took it.
struct TakenInput {
  std::string name;
  double value = 0;
  std::string unit;
  std::string origin;
};

/// One formula on one subject.
struct FormulaRow {
  std::string subject;
  std::string formula;
  std::string gives;            // "scour depth"
  std::string unit;             // of the value
  std::optional<double> value;  // none where an input is not known
  std::vector<TakenInput> inputs;
  std::vector<LimitLeft> outside;    // limits of its range that are left
  std::vector<std::string> missing;  // names of inputs that nobody tells
  std::string source;
};

/// The rows of all formulas for the kind of a subject, whose inputs are derive()d.
std::vector<FormulaRow> formula_rows(const ScourSubject& subject);

}  // namespace thalweg
