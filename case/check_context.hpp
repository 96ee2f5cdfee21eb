#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace thalweg {

/// The places where the keys and tables of a case were given, for messages.
struct CaseOrigins {
  std::string file;
  bool resolved = false;                     // the file is a case.resolved.toml: all keys are given
  std::map<std::string, std::string> given;  // "numerics.spacing", "shape.bed" … -> "case.toml:12" or "--set …"

  [[nodiscard]] bool has(const std::string& name) const { return given.contains(name); }
  /// The place of a key, or of the table it would belong to, or the beginning of the file.
  [[nodiscard]] std::string where(std::string name) const;
};

/// A table that is being checked: its name, which of its keys are given, and how its mistakes are reported.
class CheckContext {
 public:
  /// path: "numerics", "shape.bed" …; keys: the names of all keys that its table can have.
  CheckContext(const CaseOrigins& origins, std::string path, std::vector<std::string> keys, int dimension);

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] const std::vector<std::string>& keys() const { return keys_; }
  [[nodiscard]] int dimension() const { return dimension_; }
  /// True for x and z, and in 3-D for y.
  [[nodiscard]] bool uses(int axis) const { return dimension_ == 3 || axis != 1; }
  [[nodiscard]] bool resolved() const { return origins_.resolved; }
  /// The full name of one of its keys: "shape.bed.radius".
  [[nodiscard]] std::string key(std::string_view name) const;
  [[nodiscard]] bool given(std::string_view key_name) const { return origins_.has(key(key_name)); }

  /// Throws InputError "where: what; cure". `blamed` is the full name of a key or a table.
  [[noreturn]] void reject(const std::string& blamed, const std::string& what, const std::string& cure) const;

 private:
  const CaseOrigins& origins_;
  std::string path_;
  std::vector<std::string> keys_;
  int dimension_;
};

/// "x", "y" or "z".
const char* axis_name(int axis);

}  // namespace thalweg
