#pragma once

#include <filesystem>
#include <string>

namespace thalweg {

/// Keeps a second program from writing a run's folder as long as it lives. The kernel frees the lock when the process
/// ends, in whatever way; the file that carries it stays.
class RunLock {
 public:
  /// Makes the folder if it is missing. Throws InputError naming the program that is at work there.
  RunLock(std::filesystem::path folder, const std::string& program);
  ~RunLock();
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

  /// Throws RunError if the folder has been moved, deleted or exchanged since.
  void require_folder() const;

 private:
  std::filesystem::path folder_;
  int descriptor_ = -1;
};

}  // namespace thalweg
