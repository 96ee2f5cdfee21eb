#include "common/memory.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>

namespace thalweg {

MemoryEstimate estimate_memory(double particles, int dimension) {
  // Measured: 475 bytes a particle in the plane, 990 in space (bench/records), more the smaller the share of walls.
  const double solver = dimension == 2 ? 500 : 1100;
  // Counted with the stand-in for a GPU (gpu_memory_test), at the peak: lists, the columns of a domain half full, sorting, and
  // a snapshot under way.
  const double gpu = dimension == 2 ? 800 : 1300;
  constexpr double host = 120;
  return {particles * solver, particles * gpu, particles * host};
}

namespace {

namespace fs = std::filesystem;

/// The number after `key`, or with an empty `key` the file's first number; nothing if there is no number ("max").
std::optional<double> number_in(const fs::path& file, const std::string& key) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string name = key;
    double value = 0;
    if (!key.empty()) words >> name;
    if (name == key && words >> value) return value;
  }
  return std::nullopt;
}

struct GroupFiles {
  const char* limit;
  const char* used;
  const char* cache;  // in memory.stat
};
constexpr GroupFiles version_1{"memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file"};
constexpr GroupFiles version_2{"memory.max", "memory.current", "inactive_file"};

/// Memory [bytes] left to the control group `path` below `mount`: the least of its own and that of the groups it is in.
double left_in_groups(const fs::path& mount, fs::path path, const GroupFiles& files) {
  double least = HUGE_VAL;
  for (;; path = path.parent_path()) {
    const fs::path group = mount / path.relative_path();
    const auto limit = number_in(group / files.limit, "");
    const auto used = number_in(group / files.used, "");
    const double cache = number_in(group / "memory.stat", files.cache).value_or(0);
    if (limit && used) least = std::min(least, std::max(0.0, *limit - *used + cache));
    if (!path.has_relative_path()) return least;
  }
}

}  // namespace

double available_memory(const fs::path& root) {
  const double physical = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
  const auto kilobytes = number_in(root / "proc/meminfo", "MemAvailable:");
  double least = kilobytes ? 1024 * *kilobytes : physical;
  std::ifstream groups(root / "proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {  // "4:memory:/path", "0::/path" for all of version 2
    const auto first = line.find(':');
    const auto second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const fs::path path = line.substr(second + 1);
    const fs::path mount = root / "sys/fs/cgroup";
    if (controllers == "memory") least = std::min(least, left_in_groups(mount / "memory", path, version_1));
    if (controllers.empty()) least = std::min(least, left_in_groups(mount, path, version_2));
  }
  return least;
}

std::string format_bytes(double bytes) {
  constexpr std::array units{"B", "kB", "MB", "GB", "TB", "PB", "EB"};
  std::size_t unit = 0;
  for (; bytes >= 1000 && unit + 1 < units.size(); ++unit) bytes /= 1000;
  return fmt::format("{:.3g} {}", bytes, units[unit]);
}

double spacing_that_fits(double spacing, double needed, double available, int dimension) {
  const double exact = spacing * std::pow(needed / available, 1.0 / dimension);
  const double digit = std::pow(10, std::floor(std::log10(exact)) - 1);
  return std::ceil(exact / digit * (1 - 1e-12)) * digit;
}

}  // namespace thalweg
