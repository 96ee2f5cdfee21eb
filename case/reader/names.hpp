#pragma once

#include <toml++/toml.h>

#include <string>

#include "case/reader/declarations.hpp"

namespace thalweg {

/// Refuses tables and keys of `root` that `tables` does not declare, repeated tables without a name, and names used
/// twice. `file` is the case file. Throws InputError "where: what is wrong; what to do", with the nearest known name.
void check_names(const toml::table& root, const Declarations& tables, const std::string& file);

}  // namespace thalweg
