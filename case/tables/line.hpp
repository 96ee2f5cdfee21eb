#pragma once

#include <string>
#include <vector>

#include "case/tables/table.hpp"

namespace thalweg {

/// One [[line]]: a line in plan along which profiles are taken, beside the one along x.
struct ProfileLine {
  static constexpr TableHeading heading{
      "line", "3-D: a line in plan along which profiles are taken too: one such table for every line."};

  std::string name;
  std::vector<double> from;  // [m] x, y
  std::vector<double> to;    // [m] x, y

  template <class V>
  void describe(V& v) {
    v.text("name", name, "Name of the line, unique in the case; names its folder in profiles/.");
    v.quantities("from", from, "m", -1e9, 1e9, "Its start in plan: x, y.");
    v.quantities("to", to, "m", -1e9, 1e9, "Its end in plan: x, y.");
  }

  void check(const Case& whole, const CheckContext& at) const;
};

}  // namespace thalweg
