#pragma once

#include <functional>
#include <string>

#include "common/io/surface_file.hpp"

namespace thalweg::gencase {

/// Messages of gencase to its user while it works.
struct Notes {
  std::function<void(const std::string&)> say = [](const std::string&) {};   // facts, one line each
  std::function<void(const std::string&)> warn = [](const std::string&) {};  // possible mistakes, one line each
  /// Writes a picture of lines and returns the name of its file; empty if no files may be written.
  std::function<std::string(const std::string& name, const LineSet&)> draw = [](const std::string&, const LineSet&) {
    return std::string();
  };
};

}  // namespace thalweg::gencase
