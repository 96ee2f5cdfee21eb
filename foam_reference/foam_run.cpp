#include "foam_reference/foam_run.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <sstream>
#include <thread>

#include "common/error.hpp"
#include "foam_reference/child_process.hpp"

namespace thalweg::foam {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

bool on_path(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (access((fs::path(folder) / program).c_str(), X_OK) == 0) return true;
  }
  return false;
}

// One line that is rewritten on a terminal; elsewhere a line every tenth of the run.
class Progress {
 public:
  explicit Progress(double end) : end_(end), terminal_(isatty(STDERR_FILENO) == 1) {}
  ~Progress() {
    if (terminal_ && shown_ > 0) fmt::print(stderr, "\n");
  }

  void show(const std::vector<SolverStep>& steps) {
    if (steps.empty() || steps.size() == seen_) return;
    seen_ = steps.size();
    const double share = std::min(1.0, steps.back().time / end_);
    const int percent = static_cast<int>(100 * share);
    if (!terminal_ && percent < shown_ + 10) return;
    shown_ = terminal_ ? percent + 1 : percent / 10 * 10;
    const double left = share > 0 ? seconds_since(start_) * (1 - share) / share : 0;
    fmt::print(stderr, "{}foam: {:3d} %, t = {:.4f} of {:g} s, step {}, dt {:.2g} s, {:.0f} s left{}",
               terminal_ ? "\r" : "", percent, steps.back().time, end_, seen_, steps.back().dt, left,
               terminal_ ? "   " : "\n");
    std::fflush(stderr);
  }

 private:
  double end_;
  bool terminal_;
  std::size_t seen_ = 0;
  int shown_ = 0;
  Clock::time_point start_ = Clock::now();
};

// The log Allrun names when one of its programs fails; its own where it fails otherwise.
fs::path failed_log(const fs::path& folder) {
  const std::string announcement = "failed: see ";
  std::ifstream stream(folder / "log.Allrun");
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with(announcement)) return folder / line.substr(announcement.size());
  }
  return folder / "log.Allrun";
}

[[noreturn]] void report_failure(const fs::path& folder, const SolverLog& log, double end,
                                 const std::string& application) {
  const fs::path failed = failed_log(folder);
  const std::string reason = fatal_message(failed);
  const std::string because = reason.empty() ? "" : " (" + reason + ")";
  if (failed.filename() != log.file().filename() || log.steps().empty()) {
    throw RunError(fmt::format("{}: {} failed{}; read this log, check that OpenFOAM and the case fit together",
                               failed.string(), failed.filename().string().substr(4), because));
  }
  throw RunError(
      fmt::format("{}: {} failed at t = {:g} of {:g} s{}; try another cell size (--cell), or "
                  "a smaller maxCo in system/controlDict and ./Allclean && ./Allrun",
                  failed.string(), application, log.steps().back().time, end, because));
}

// Steps shorten for a while at an impact; a millionth of the usual one means that speeds grow without bound.
void check_divergence(const SolverLog& log) {
  const auto& steps = log.steps();
  if (steps.size() < 10) return;
  const double usual = std::ranges::max_element(steps, {}, &SolverStep::dt)->dt;
  if (steps.back().dt > 1e-6 * usual) return;
  throw RunError(
      fmt::format("{}: the run diverged at t = {:g} s: the time step fell from {:.2g} s to {:.2g} s; try "
                  "another cell size (--cell), or a smaller maxCo in system/controlDict and ./Allclean && "
                  "./Allrun",
                  log.file().string(), steps.back().time, usual, steps.back().dt));
}

}  // namespace

void require_openfoam() {
  for (const char* program : {"blockMesh", "setFields", "multiphaseInterFoam"}) {
    if (on_path(program)) continue;
    throw InputError(std::string("OpenFOAM is not installed (no ") + program +
                     " on PATH); install it with `apt-get install openfoam`, or leave the mesh model out");
  }
}

FoamRun run_foam(const fs::path& folder, double end, const std::string& application) {
  const SignalWatch signals;
  const auto start = Clock::now();
  ChildProcess allrun({"/bin/sh", (folder / "Allrun").string()}, folder / "log.Allrun");
  SolverLog log(folder / ("log." + application));
  {
    Progress progress(end);
    while (allrun.running()) {
      if (const int signal = SignalWatch::received(); signal != 0) {
        allrun.end();
        throw Interrupted{signal};
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      log.read_on();
      check_divergence(log);
      progress.show(log.steps());
    }
    log.read_on();
    progress.show(log.steps());
  }
  if (!allrun.succeeded()) report_failure(folder, log, end, application);
  return {allrun.cpu_seconds(), seconds_since(start), log.version(), log.steps()};
}

}  // namespace thalweg::foam
