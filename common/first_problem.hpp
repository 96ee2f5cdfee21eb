#pragma once

#include <algorithm>
#include <exception>
#include <string>
#include <vector>

#include "common/ranks.hpp"

// Ranks try something together, and one of them may fail. All have to learn of it, or the others wait for that one for ever.
namespace thalweg {

/// Why what() has failed on this rank; empty if it has not.
template <class What>
std::string problem_of(const What& what) {
  try {
    what();
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

/// A problem and the rank that has it; no rank (-1) where there is none.
struct RankProblem {
  int rank = -1;
  std::string text;
};

/// The problem of the first rank that has one. Every rank says its own, which is empty where all is well.
inline RankProblem first_problem(Ranks& ranks, const std::string& mine) {
  Bytes own;
  append_to(own, mine.data(), mine.size());
  const std::vector<Bytes> all = exchange_any(ranks, std::vector<Bytes>(static_cast<std::size_t>(ranks.size()), own));
  const auto first = std::find_if(all.begin(), all.end(), [](const Bytes& problem) { return !problem.empty(); });
  if (first == all.end()) return {};
  RankProblem found{static_cast<int>(first - all.begin()), std::string(first->size(), ' ')};
  MessageReader(*first).read(found.text.data(), found.text.size());
  return found;
}

}  // namespace thalweg
