#include "case/reader/mistakes.hpp"

#include <algorithm>
#include <cstdlib>

#include "common/input_errors.hpp"

namespace thalweg {

namespace {

/// The line that a message "case.toml:12: …" names; 0 for one of the command line.
long line_in(const std::string& message) {
  const auto end = message.find(": ");
  const auto colon = end == std::string::npos ? end : message.rfind(':', end - 1);
  return colon == std::string::npos ? 0 : std::strtol(message.c_str() + colon + 1, nullptr, 10);
}

}  // namespace

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
  std::vector<std::string> in_order = messages_;
  std::stable_sort(in_order.begin(), in_order.end(),
                   [](const std::string& a, const std::string& b) { return line_in(a) < line_in(b); });
  throw InputErrors(in_order);
}

}  // namespace thalweg
