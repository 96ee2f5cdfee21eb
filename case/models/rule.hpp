#pragma once

#include <string>

#include "case/tables/table.hpp"

// An optional model of a run is a struct in case/models/ (case/models/all.hpp lists them) with
//   static bool is_on(const Case&)        true if the case asks for it
//   static std::vector<Rule> rules()      what it excludes and what it needs; left out if there is nothing
// Its words, where it has some, stand in the same file: the enumerators of a key of [model] or [numerics] and their
// choices().
namespace thalweg::models {

/// One thing that a model excludes or needs. A case in which the model is on and that breaks the rule is refused.
struct Rule {
  bool (*broken)(const Case&);
  std::string blamed;  // full name of a key: "model.seepage"
  std::string what;    // the contradiction
  std::string cure;
};

}  // namespace thalweg::models
