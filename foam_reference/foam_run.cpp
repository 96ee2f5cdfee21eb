#include "foam_reference/foam_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "common/error.hpp"
#include "common/process.hpp"
#include "common/progress.hpp"

namespace thalweg::foam {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Shows how far the solver is; in a log with a line every tenth of the run.
class Progress {
 public:
  explicit Progress(double end) : end_(end) {}

  void show(const std::vector<SolverStep>& steps) {
    if (steps.empty()) return;
    const double share = std::min(1.0, steps.back().time / end_);
    const int percent = static_cast<int>(100 * share);
    if (!line_.on_terminal() && percent < shown_ + 10) return;
    shown_ = percent / 10 * 10;
    line_.show([&] {
      return progress_text({.what = "foam",
                            .share = share,
                            .elapsed = line_.elapsed(),
                            .facts = fmt::format("t = {:.4f} of {:g} s, step {}, dt {:.2g} s", steps.back().time, end_,
                                                 steps.size(), steps.back().dt)});
    });
  }

 private:
  double end_;
  int shown_ = 0;  // [%] tenth of the last line in a log
  ProgressLine line_{{.width = 90, .log_pause = std::chrono::milliseconds(0)}};
};

/// A way to a folder that OpenFOAM can go: it cuts paths at blanks and quotes, and refuses those of more than 1024
/// characters. Where the folder's own path is such a one, the way is a link in the system's temporary folder, which goes
/// with this object.
class PlainPath {
 public:
  explicit PlainPath(const fs::path& folder) : path_(fs::absolute(folder)) {
    constexpr std::size_t longest = 800;  // leaves room for the names in it
    const std::string given = path_.string();
    if (given.size() <= longest && given.find_first_of(" \t\"'`;{}$\\") == std::string::npos) return;
    std::string name = (fs::temp_directory_path() / "thalweg-foam-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw RunError(name + ": cannot be made; give a temporary folder that can be written to (TMPDIR)");
    temporary_ = name;
    fs::create_directory_symlink(path_, temporary_ / "case");
    path_ = temporary_ / "case";
  }
  ~PlainPath() {
    std::error_code ignored;
    if (temporary_.empty()) return;
    fs::remove(temporary_ / "case", ignored);  // the link, not what it leads to
    fs::remove(temporary_, ignored);
  }
  PlainPath(const PlainPath&) = delete;
  PlainPath& operator=(const PlainPath&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
  fs::path temporary_;
};

// The log that Allrun names if one of its programs fails; Allrun's own log if it fails otherwise.
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

// Throws RunError if the step has fallen to a millionth of the usual one: speeds then grow without bound. At an impact
// steps shorten too, but by far less.
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
  const PlainPath plain(folder);
  ChildProcess allrun({"/bin/sh", (plain.path() / "Allrun").string()},
                      {.log = folder / "log.Allrun", .own_group = true});
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
  if (allrun.wait() != 0) report_failure(folder, log, end, application);
  return {allrun.cpu_seconds(), seconds_since(start), log.version(), log.steps()};
}

}  // namespace thalweg::foam
