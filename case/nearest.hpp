#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace thalweg {

/// The candidate nearest to `word` by edit distance, or nothing when none is near enough to be meant.
std::optional<std::string> nearest(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace thalweg
