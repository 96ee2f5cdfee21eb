#pragma once

#include <limits>
#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace thalweg::test {

/// The range in which a measure has to lie, and the reason.
struct Bound {
  double at_least = -std::numeric_limits<double>::infinity();
  double at_most = std::numeric_limits<double>::infinity();
  std::string why;

  [[nodiscard]] bool holds(double value) const { return value >= at_least && value <= at_most; }  // false for NaN
};

/// A row of cases/stability/suite.toml: a scene, the keys changed in it, and the bounds on its measures.
struct StabilityCase {
  std::string name;
  std::string scene;                    // folder in cases/stability
  std::vector<std::string> set;         // overrides of the scene, as on the command line
  std::string tries;                    // the behaviour that the case tests
  std::map<std::string, Bound> bounds;  // by the name of the measure
  std::vector<std::string> fails;       // words of the diagnosis it has to stop with; empty: it has to run to its end
};

/// The text by which GoogleTest names a case in its messages.
inline void PrintTo(const StabilityCase& c, std::ostream* to) { *to << c.tries; }

/// The table, in its order. The bounds of [every_run] stand in every case that has to run to its end and has no bound
/// of its own by that name. Throws std::runtime_error "file: what is wrong".
std::vector<StabilityCase> read_suite();

}  // namespace thalweg::test
