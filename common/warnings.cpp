#include "common/warnings.hpp"

#include <algorithm>
#include <fstream>

namespace thalweg {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> lines_of(const fs::path& file) {
  constexpr std::size_t most = 100;  // more than anyone reads
  std::vector<std::string> lines;
  std::ifstream from(file);
  for (std::string line; lines.size() < most && std::getline(from, line);)
    if (!line.empty()) lines.push_back(line);
  return lines;
}

}  // namespace

WarningFile::WarningFile(const RunFolder& run, const std::string& program)
    : file_(run.warnings() / (program + ".txt")) {}

void WarningFile::clear() const {
  std::error_code ignored;
  fs::remove(file_, ignored);
}

void WarningFile::add(std::string warning) const {
  std::replace(warning.begin(), warning.end(), '\n', ' ');
  const std::vector<std::string> known = lines_of(file_);
  if (std::find(known.begin(), known.end(), warning) != known.end()) return;
  std::error_code ignored;
  if (!fs::is_directory(file_.parent_path().parent_path(), ignored)) return;  // the run's folder itself has gone
  fs::create_directory(file_.parent_path(), ignored);
  std::ofstream(file_, std::ios::app) << warning << '\n';
}

std::vector<std::string> warnings_of_programs(const RunFolder& run) {
  std::vector<std::string> all;
  for (const char* program : {"gencase", "solver", "foam", "run"}) {
    for (const std::string& line : lines_of(run.warnings() / (std::string(program) + ".txt"))) {
      all.push_back(std::string(program) + ": " + line);
    }
  }
  return all;
}

void forget_warnings(const RunFolder& run) {
  std::error_code ignored;
  fs::remove_all(run.warnings(), ignored);
}

}  // namespace thalweg
