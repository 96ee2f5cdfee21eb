#include "foam_reference/reference_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "common/console.hpp"
#include "common/error.hpp"
#include "common/process.hpp"
#include "common/profile.hpp"
#include "common/whole_file.hpp"

namespace thalweg::foam {
namespace {

namespace fs = std::filesystem;

bool holds(const fs::path& file, const std::string& text) {
  std::ifstream stream(file, std::ios::binary);
  return stream && std::string(std::istreambuf_iterator<char>(stream), {}) == text;
}

// True if the folder holds a finished run of these files. summary.csv is written last.
bool is_current(const fs::path& folder, const CaseFiles& files) {
  if (!fs::exists(folder / "summary.csv")) return false;
  for (const auto& [path, text] : files) {
    if (!holds(folder / "case" / path, text)) return false;
  }
  return true;
}

// The times to compare may have changed although the dictionaries have not, since fields are written at more times.
bool has_profiles(const fs::path& folder, const Case& scene) {
  return std::ranges::all_of(scene.compare.times,
                             [&](double time) { return fs::exists(folder / "profiles" / profile_file_name(time)); });
}

void write_files(const fs::path& folder, const CaseFiles& files) {
  for (const auto& file : files) {
    write_whole_text(folder / file.first, [&](std::ostream& stream) { stream << file.second; });
  }
  for (const char* script : {"Allrun", "Allclean"}) {
    fs::permissions(folder / script, fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                    fs::perm_options::add);
  }
}

// Removes the results of an earlier run, so that none of them can pass for one of the new run.
void clean(const fs::path& folder, const FoamCase& foam_case) {
  fs::remove(folder / "summary.csv");
  fs::remove(folder / "history.csv");
  fs::remove(folder / "gauges.csv");
  fs::remove_all(folder / "profiles");
  fs::remove_all(folder / "case" / "system");
  fs::remove_all(folder / "case" / "constant");
  fs::remove_all(folder / "case" / "0.orig");
  write_files(folder / "case", scripts(foam_case));
  ChildProcess({"/bin/sh", (folder / "case" / "Allclean").string()}, {.log = folder / "log.Allclean"}).wait();
  fs::remove(folder / "log.Allclean");
}

void report(const std::vector<VolumeBalance>& balances, const FoamRun& run, const Warn& warn) {
  std::string line =
      fmt::format("foam: {} steps in {:.1f} s ({:.1f} s CPU)", run.steps.size(), run.wall_seconds, run.cpu_seconds);
  for (const VolumeBalance& balance : balances)
    line += fmt::format(", {} volume {:+.1e}", balance.phase, balance.relative_error());
  say_beside(line);
  for (const VolumeBalance& balance : balances) {
    if (std::abs(balance.relative_error()) <= volume_tolerance) continue;
    warn(fmt::format(
        "the volume of {} changed by {:.2g} % (history.csv shows when); compare with a smaller --cell before "
        "trusting this run",
        balance.phase, 100 * balance.relative_error()));
  }
}

}  // namespace

Reference reference_run(const FoamCase& foam_case, const fs::path& folder, const Warn& warn) {
  const CaseFiles files = case_files(foam_case);
  const fs::path root = fs::absolute(folder);
  if (is_current(root, files)) {
    if (!has_profiles(root, foam_case.scene)) write_profiles(foam_case, root);
    return Reference::already_there;
  }
  require_openfoam();
  try {
    clean(root, foam_case);
    write_files(root / "case", files);
  } catch (const fs::filesystem_error& error) {
    throw RunError(std::string(error.what()) + "; check the permissions of " + root.string());
  }
  const FoamRun run = run_foam(root / "case", foam_case.scene.output.end, foam_case.application());
  report(write_results(foam_case, root, run), run, warn);
  return Reference::computed;
}

}  // namespace thalweg::foam
