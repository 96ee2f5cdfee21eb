#pragma once

#include <functional>
#include <string>

#include "common/io/surface_file.hpp"

namespace thalweg::gencase {

/// What gencase tells its user on the way.
struct Notes {
  std::function<void(const std::string&)> say = [](const std::string&) {};   // facts, one line each, as they are known
  std::function<void(const std::string&)> warn = [](const std::string&) {};  // what the user should look at
  /// Writes lines to look at, and returns the file's name; empty when nothing may be written.
  std::function<std::string(const std::string& name, const LineSet&)> draw = [](const std::string&, const LineSet&) {
    return std::string();
  };
};

}  // namespace thalweg::gencase
