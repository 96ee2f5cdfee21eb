#pragma once

#include <string>

#include "case/tables/table.hpp"

namespace thalweg {

/// [case]: name and origin of the scene.
struct CaseInfo {
  static constexpr TableHeading heading{"case", "What the scene is."};

  std::string name;
  std::string title;
  std::string source;
  int dimension = 2;

  template <class V>
  void describe(V& v) {
    v.text("name", name, "Short name, used for folders and file names; default: the name of the case's folder.");
    v.text("title", title, "One line for reports.");
    v.text("source", source, "Where geometry, constants and data come from.");
    v.integer("dimension", dimension, 2, 3, "2: the plane x-z per metre of width; 3: space.");
  }

  void set_defaults(const GivenWords& given);
  void check(const Case& whole, const CheckContext& at) const;
};

}  // namespace thalweg
