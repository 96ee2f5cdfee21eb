#pragma once

#include <map>
#include <string>

#include "case/case.hpp"

namespace thalweg {

/// Where the keys and tables of a case were given, for messages.
struct CaseOrigins {
  std::string file;
  std::map<std::string, std::string> given;  // "numerics.spacing", "shape.bed" … -> "case.toml:12" or "--set …"

  [[nodiscard]] bool has(const std::string& name) const { return given.contains(name); }
  /// The place of a key, or of the table it would belong to, or the beginning of the file.
  [[nodiscard]] std::string where(std::string name) const;
};

/// Checks what concerns several keys at once: shapes that refer to each other, materials, times, directions, extents.
/// Throws InputError "where: what is wrong; what to do".
void check_case(const Case& read, const CaseOrigins& origins);

}  // namespace thalweg
