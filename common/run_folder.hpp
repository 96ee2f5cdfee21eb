#pragma once

#include <filesystem>
#include <string>

namespace thalweg {

/// The names of the files and folders in a run's folder; they stand nowhere else.
struct RunFolder {
  std::filesystem::path root;

  /// The case as resolved (defaults and --set applied), written by gencase; the other programs read this one.
  [[nodiscard]] std::filesystem::path resolved_case() const { return root / "case.resolved.toml"; }
  [[nodiscard]] std::filesystem::path particles() const { return root / "particles.vtp"; }
  [[nodiscard]] std::filesystem::path snapshots() const { return root / "snapshots"; }
  [[nodiscard]] std::filesystem::path snapshot_series() const { return root / "snapshots.pvd"; }
  [[nodiscard]] std::filesystem::path history() const { return root / "history.csv"; }
  [[nodiscard]] std::filesystem::path gauges() const { return root / "gauges.csv"; }
  [[nodiscard]] std::filesystem::path timing() const { return root / "timing.csv"; }
  [[nodiscard]] std::filesystem::path summary() const { return root / "summary.csv"; }
  [[nodiscard]] std::filesystem::path excluded() const { return root / "excluded.csv"; }
  [[nodiscard]] std::filesystem::path checkpoint() const { return root / "checkpoint.vtp"; }
  /// The checkpoint before the last.
  [[nodiscard]] std::filesystem::path previous_checkpoint() const { return root / "checkpoint.previous.vtp"; }
  [[nodiscard]] std::filesystem::path diverged() const { return root / "diverged.vtp"; }
  /// Carries the lock of the program that writes the folder (run_lock.hpp).
  [[nodiscard]] std::filesystem::path lock() const { return root / ".lock"; }
  /// The lines of all programs, in order of time (console.hpp).
  [[nodiscard]] std::filesystem::path log() const { return root / "log.txt"; }
  /// Holds the warnings of the programs (warnings.hpp).
  [[nodiscard]] std::filesystem::path warnings() const { return root / "warnings"; }
  [[nodiscard]] std::filesystem::path profiles() const { return root / "profiles"; }
  [[nodiscard]] std::filesystem::path surfaces() const { return root / "surfaces"; }
  [[nodiscard]] std::filesystem::path view_script() const { return root / "view.py"; }
  [[nodiscard]] std::filesystem::path report() const { return root / "report"; }
  [[nodiscard]] std::filesystem::path foam() const { return root / "foam"; }
  /// The same run with `times` the spacing (compare.runs).
  [[nodiscard]] RunFolder coarser(int times) const { return {root / "coarser" / (std::to_string(times) + "x")}; }
  /// The same run with the factor of its bed divided by `times` (compare.factor_runs).
  [[nodiscard]] RunFolder slower(int times) const { return {root / "slower" / (std::to_string(times) + "x")}; }
};

}  // namespace thalweg
