#include "common/app/programs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>

#include "case/nearest.hpp"
#include "common/app/verbs.hpp"
#include "common/error.hpp"
#include "common/installation.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view prefix = "thalweg-";

}  // namespace

std::vector<std::string> installed_stages() {
  std::vector<std::string> stages;
  for (const auto& entry : fs::directory_iterator(program_folder())) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(prefix) && access(entry.path().c_str(), X_OK) == 0)
      stages.push_back(name.substr(prefix.size()));
  }
  std::sort(stages.begin(), stages.end());
  return stages;
}

fs::path stage_program(const std::string& stage) {
  const std::vector<std::string> stages = installed_stages();
  if (std::find(stages.begin(), stages.end(), stage) != stages.end()) {
    return program_folder() / fmt::format("{}{}", prefix, stage);
  }
  std::vector<std::string> commands;
  for (const Verb& verb : verbs()) commands.push_back(verb.name);
  const auto near = nearest(stage, commands);
  throw InputError(fmt::format(
      "thalweg: there is no command {}; {}", stage,
      near ? fmt::format("did you mean {}?", *near) : fmt::format("the commands are {}", fmt::join(commands, ", "))));
}

}  // namespace thalweg
