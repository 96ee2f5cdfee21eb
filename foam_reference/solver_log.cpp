#include "foam_reference/solver_log.hpp"

#include <cstdlib>

namespace thalweg::foam {
namespace {

// The number after `words` in `line`; false when the line does not hold them.
bool number_after(const std::string& line, const std::string& words, double& value) {
  const std::size_t at = line.find(words);
  if (at == std::string::npos) return false;
  const char* text = line.c_str() + at + words.size();
  char* end = nullptr;
  const double read = std::strtod(text, &end);
  if (end == text) return false;
  value = read;
  return true;
}

std::string trimmed(const std::string& line) {
  const std::size_t first = line.find_first_not_of(" \t");
  return first == std::string::npos ? "" : line.substr(first, line.find_last_not_of(" \t") - first + 1);
}

}  // namespace

void SolverLog::read_on() {
  if (!stream_.is_open()) stream_.open(file_);
  if (!stream_.is_open()) return;
  stream_.clear();
  for (std::string line; std::getline(stream_, line);) {
    rest_ += line;
    if (stream_.eof()) return;  // no end of line yet: the rest follows
    read_line(rest_);
    rest_.clear();
  }
}

void SolverLog::read_line(const std::string& line) {
  double value = 0;
  if (line.starts_with("deltaT = ")) {
    number_after(line, "deltaT = ", dt_);
  } else if (line.starts_with("Time = ") && number_after(line, "Time = ", value)) {
    steps_.push_back({value, dt_, steps_.empty() ? 0 : steps_.back().continuity_error});
  } else if (line.starts_with("time step continuity errors") && !steps_.empty()) {
    number_after(line, "cumulative = ", steps_.back().continuity_error);
  } else if (line.starts_with("Build") && version_.empty()) {
    version_ = trimmed(line.substr(line.find(':') + 1));
  }
}

std::string fatal_message(const std::filesystem::path& log) {
  std::ifstream stream(log);
  std::string message;
  for (std::string line; std::getline(stream, line);) {
    if (line.find("sigFpe") != std::string::npos) return "floating point exception";
    if (line.find("FOAM FATAL") == std::string::npos) continue;
    // The text follows the announcement until an empty line.
    while (std::getline(stream, line)) {
      const std::string words = trimmed(line);
      if (words.empty() && !message.empty()) break;
      if (!message.empty()) message += ' ';
      message += words;
    }
    return message;
  }
  return message;
}

}  // namespace thalweg::foam
