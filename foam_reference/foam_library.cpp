#include "foam_reference/foam_library.hpp"

#include "common/installation.hpp"
#include "common/process.hpp"

namespace thalweg::foam {

namespace fs = std::filesystem;

std::optional<fs::path> foam_library() {
  const fs::path script = shared_file("tools/foam-library");
  if (!fs::exists(script)) return std::nullopt;
  ChildProcess build({script.string()}, {.own_group = true, .piped = 1});  // it starts apt, tar and compilers
  const std::optional<std::string> folder = build.read_line();
  if (build.wait() != 0 || !folder) return std::nullopt;
  return fs::path(*folder);
}

}  // namespace thalweg::foam
