#pragma once

#include <toml++/toml.h>

#include <string>

#include "case/reader/declarations.hpp"
#include "case/reader/mistakes.hpp"

namespace thalweg {

/// Refuses tables and keys of `root` that `tables` does not declare; these go to `mistakes`, with the nearest known name. Throws
/// InputError where the tables cannot be read any further: repeated tables without a name, names used twice. `file` is the case file.
void check_names(const toml::table& root, const Declarations& tables, const std::string& file, Mistakes& mistakes);

}  // namespace thalweg
