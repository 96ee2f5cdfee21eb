#pragma once

#include <string>
#include <vector>

#include "common/error.hpp"

namespace thalweg {

/// Several mistakes of one input, each a message as InputError has it. `what()` is the first; run_program() prints a line for each.
class InputErrors : public InputError {
 public:
  explicit InputErrors(std::vector<std::string> messages)
      : InputError(messages.front()), messages_(std::move(messages)) {}

  [[nodiscard]] const std::vector<std::string>& messages() const { return messages_; }

 private:
  std::vector<std::string> messages_;
};

}  // namespace thalweg
