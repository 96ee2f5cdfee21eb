#include "common/installation.hpp"

#include <algorithm>
#include <array>

namespace thalweg {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view core_prefix = "thalweg_core_";
constexpr std::string_view core_suffix = ".so";

std::array<fs::path, 3> core_folders() {
  const fs::path programs = program_folder();
  return {programs, programs.parent_path() / "lib" / "thalweg", programs.parent_path() / "bin"};
}

}  // namespace

fs::path program_folder() {
  std::error_code ignored;
  return fs::read_symlink("/proc/self/exe", ignored).parent_path();
}

fs::path shared_file(const std::string& name) { return program_folder().parent_path() / "share" / "thalweg" / name; }

fs::path find_core(const std::string& name) {
  return find_module(std::string(core_prefix) + name + std::string(core_suffix));
}

fs::path find_module(const std::string& file) {
  for (const fs::path& folder : core_folders()) {
    if (fs::exists(folder / file)) return folder / file;
  }
  return {};
}

std::vector<std::string> installed_cores() {
  std::vector<std::string> names;
  for (const fs::path& folder : core_folders()) {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
      const std::string file = entry.path().filename().string();
      if (!file.starts_with(core_prefix) || !file.ends_with(core_suffix)) continue;
      names.push_back(file.substr(core_prefix.size(), file.size() - core_prefix.size() - core_suffix.size()));
    }
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

}  // namespace thalweg
