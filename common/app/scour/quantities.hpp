#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace thalweg {

/// A number that the scour formulas take: the case may tell it, and an option --name gives it.
struct QuantityKind {
  const char* name;
  const char* unit;  // SI; empty: a plain number
  double low;        // least value; 0 is excluded where `positive`
  double high;
  bool positive;
  const char* meaning;
};

/// All of them, in the order in which help lists them.
const std::vector<QuantityKind>& quantity_kinds();
/// The one of this name; the name has to be one of them.
const QuantityKind& quantity_kind(std::string_view name);

/// The value that a text gives a quantity: "0.3 m/s", or "0.1" where it is a plain number. Throws InputError naming
/// the option.
double parse_option(const QuantityKind& kind, const std::string& text);

/// A value in SI units, and where it comes from, for the table: "shape \"pile\"", "--depth", "discharge/depth".
struct KnownValue {
  double value = 0;
  std::string origin;
};

/// The quantities that are known.
class Inputs {
 public:
  void set(const std::string& name, double value, const std::string& origin);
  /// Does nothing if the quantity is known already.
  void set_if_unknown(const std::string& name, double value, const std::string& origin);
  void forget(const std::string& name) { known_.erase(name); }
  /// Takes over all that the other one knows.
  void take_over(const Inputs& other);
  [[nodiscard]] bool has(const std::string& name) const { return known_.contains(name); }
  /// Not a number if it is not known.
  [[nodiscard]] double value(const std::string& name) const;
  [[nodiscard]] const KnownValue* find(const std::string& name) const;

 private:
  std::map<std::string, KnownValue> known_;
};

/// Adds what follows from the known: constants of water and quartz, velocity and discharge from each other or from a
/// slope, friction velocity, Shields numbers, settling velocity, and what formulas take in place of a value that
/// nobody gives.
void derive(Inputs& inputs);

}  // namespace thalweg
