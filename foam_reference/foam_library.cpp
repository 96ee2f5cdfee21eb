#include "foam_reference/foam_library.hpp"

#include <array>
#include <cstdio>
#include <string>

namespace thalweg::foam {

namespace fs = std::filesystem;

std::optional<fs::path> foam_library() {
  // Programs lie in bin/, what they need besides in share/thalweg, in a build folder as where they are installed.
  const fs::path programs = fs::read_symlink("/proc/self/exe").parent_path();
  const fs::path script = programs.parent_path() / "share" / "thalweg" / "tools" / "foam-library";
  if (!fs::exists(script)) return std::nullopt;
  std::string quoted = "'";
  for (const char c : script.string()) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  FILE* output = popen((quoted + "'").c_str(), "r");
  if (output == nullptr) return std::nullopt;
  std::string folder;
  std::array<char, 4096> part{};
  while (std::fgets(part.data(), static_cast<int>(part.size()), output) != nullptr) folder += part.data();
  if (pclose(output) != 0) return std::nullopt;
  while (!folder.empty() && folder.back() == '\n') folder.pop_back();
  return fs::path(folder);
}

}  // namespace thalweg::foam
