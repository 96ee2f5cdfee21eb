#include "case/reader/mistakes.hpp"

#include <algorithm>

#include "common/input_errors.hpp"

namespace thalweg {

bool Mistakes::attempt(const std::function<void()>& part) {
  const auto keep = [&](const std::string& message) {
    if (std::find(messages_.begin(), messages_.end(), message) == messages_.end()) messages_.push_back(message);
  };
  try {
    part();
    return true;
  } catch (const InputErrors& errors) {
    for (const std::string& message : errors.messages()) keep(message);
  } catch (const MissingKey& missing) {
    if (!with_unknown_keys_.contains(missing.table())) keep(missing.what());
  } catch (const InputError& error) {
    keep(error.what());
  }
  return false;
}

void Mistakes::throw_any() const {
  if (messages_.empty()) return;
  if (messages_.size() == 1) throw InputError(messages_.front());
  throw InputErrors(messages_);
}

}  // namespace thalweg
