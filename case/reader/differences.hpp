#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"

namespace thalweg {

/// A key that two cases give different values, as their files would write them.
struct KeyDifference {
  std::string key;  // "numerics.cfl", "shape.bed.from", "materials.sand.cohesion"
  std::string before;
  std::string now;  // empty, as `before`: only the other case has the key
};

/// Every key of a case with its value, and the hashes of the files it names; differences() compares such texts.
std::string case_text(const Case& of);

/// The keys in which two texts differ, in the order of the alphabet. Throws InputError if one is no such text.
std::vector<KeyDifference> differences(const std::string& before, const std::string& now);

}  // namespace thalweg
