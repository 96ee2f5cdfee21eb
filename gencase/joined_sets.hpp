#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace thalweg::gencase {

/// Numbers 0 … n-1 in sets that can be joined (union-find with halved paths). The lowest number stands for a set.
class JoinedSets {
 public:
  explicit JoinedSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t j) {
    i = root(i);
    j = root(j);
    parent_[i < j ? j : i] = i < j ? i : j;
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace thalweg::gencase
