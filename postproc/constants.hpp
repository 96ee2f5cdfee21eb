#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"

namespace thalweg {

/// One key of a resolved case as a reader wants to see it.
struct Constant {
  std::string key;
  std::string value;  // with its unit
  std::string meaning;
  bool is_default = false;
};

struct ConstantTable {
  std::string name;
  std::vector<Constant> rows;
};

/// Every key of a case with its value, table by table, read from the declarations the case parser uses. A shape is one
/// row with the keys that mean something for it.
std::vector<ConstantTable> list_constants(const Case& resolved);

/// A part of the model and whether this run has it.
struct Switch {
  std::string name;
  bool on = false;
  std::string meaning;
};

/// The parts of the model, on or off: the choices of [model], and the numerical terms that a zero switches off.
std::vector<Switch> list_switches(const Case& resolved);

}  // namespace thalweg
