#include "foam_reference/foam_library.hpp"

#include "common/process.hpp"

namespace thalweg::foam {

namespace fs = std::filesystem;

std::optional<fs::path> foam_library() {
  // Programs lie in bin/ and the files that they need in share/thalweg, in a build folder as well as where they are
  // installed.
  const fs::path programs = fs::read_symlink("/proc/self/exe").parent_path();
  const fs::path script = programs.parent_path() / "share" / "thalweg" / "tools" / "foam-library";
  if (!fs::exists(script)) return std::nullopt;
  ChildProcess build({script.string()}, {.own_group = true, .piped = 1});  // it starts apt, tar and compilers
  const std::optional<std::string> folder = build.read_line();
  if (build.wait() != 0 || !folder) return std::nullopt;
  return fs::path(*folder);
}

}  // namespace thalweg::foam
