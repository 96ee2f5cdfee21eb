#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/run_folder.hpp"

// Warnings that the programs print are kept in the run's folder too, in warnings/PROGRAM.txt, so that the report shows
// them to who has not seen the terminal.
namespace thalweg {

/// The warnings of one program. Each is a line, and in the file at once: a program that is killed loses none.
class WarningFile {
 public:
  WarningFile(const RunFolder& run, const std::string& program);

  /// Forgets those of an earlier run.
  void clear() const;
  /// Adds one, if it is not there yet. A file that cannot be written is no reason to stop: the warning has been printed.
  void add(std::string warning) const;

 private:
  std::filesystem::path file_;
};

/// The warnings of gencase, solver, foam and of the whole pipeline (run), each as "PROGRAM: warning", in this order.
std::vector<std::string> warnings_of_programs(const RunFolder& run);

/// Forgets the warnings of all programs, those of a scene that is filled anew.
void forget_warnings(const RunFolder& run);

}  // namespace thalweg
