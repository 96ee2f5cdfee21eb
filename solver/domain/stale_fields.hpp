#pragma once

#include <algorithm>
#include <vector>

#include "solver/backend/device.hpp"

namespace thalweg {

/// Keeps account of the fields of a halo: copies of particles that another machine owns. A field that a body has
/// written is stale there until it is exchanged; before a body reads it of neighbours it has to be fresh. What is to be
/// exchanged when follows from the declarations of the bodies alone; a body that may be skipped counts as run. On one machine
/// there is no halo and no listener.
class StaleFields : public AccessListener {
 public:
  void before(const Access& access, const int* flag) final {
    if (begin(access, flag)) arrive();
  }

  bool begin(const Access& access, const int*) final {
    std::vector<const Field*> wanted;
    for (const Field* field : access.neighbours) {
      if (is_stale(field)) wanted.push_back(field);
    }
    if (wanted.empty()) return false;
    start(wanted);
    for (const Field* field : wanted) std::erase(stale_, field);
    return true;
  }

  void after(const Access& access, const int*) final {
    for (const Field* field : access.writes) {
      if (!is_stale(field)) stale_.push_back(field);
    }
  }

 protected:
  /// Starts to bring these fields of the halo up to date; arrive() ends it.
  virtual void start(const std::vector<const Field*>& fields) = 0;
  /// All fields of the copies are as those they are copies of.
  void forget_all() { stale_.clear(); }

 private:
  [[nodiscard]] bool is_stale(const Field* field) const {
    return std::find(stale_.begin(), stale_.end(), field) != stale_.end();
  }

  std::vector<const Field*> stale_;
};

}  // namespace thalweg
