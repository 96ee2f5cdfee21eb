#pragma once

#include <string>
#include <utility>
#include <vector>

// Ranges of validity of empirical formulas. A formula gives its value outside its range too; the caller says which
// limits are left, because a number that looks right is worse than none.
namespace thalweg {

/// A limit of a formula's range that the inputs leave, such as "y/a 0.1 < 0.8".
struct LimitLeft {
  std::string name;  // of the quantity, in the formula's symbols
  double value = 0;
  double limit = 0;
  bool below = false;  // true: the value is less than the limit; false: more
};

/// Collects the limits that are left. A value that is not a number (an input that nobody knows) leaves none.
class Limits {
 public:
  Limits& at_least(std::string name, double value, double limit) {
    if (value < limit) left_.push_back({std::move(name), value, limit, true});
    return *this;
  }
  Limits& at_most(std::string name, double value, double limit) {
    if (value > limit) left_.push_back({std::move(name), value, limit, false});
    return *this;
  }
  Limits& between(const std::string& name, double value, double low, double high) {
    return at_least(name, value, low).at_most(name, value, high);
  }
  [[nodiscard]] const std::vector<LimitLeft>& left() const { return left_; }

 private:
  std::vector<LimitLeft> left_;
};

}  // namespace thalweg
