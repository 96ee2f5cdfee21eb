#include "postproc/gnuplot.hpp"

#include <cstdlib>
#include <fstream>

#include "common/error.hpp"
#include "common/process.hpp"

namespace thalweg {
namespace {

// gnuplot's complaint on one line, without the echo of the script and the caret under it.
std::string complaint_in(const std::filesystem::path& log) {
  std::ifstream stream(log);
  std::string line;
  std::string last;
  while (std::getline(stream, line)) {
    if (line.find_first_not_of(" ^\t\r") != std::string::npos) last = line;
  }
  return last.empty() ? "no message" : last;
}

}  // namespace

GnuplotResult run_gnuplot(const std::filesystem::path& script) {
  const char* other_program = std::getenv("THALWEG_GNUPLOT");
  const std::string program = other_program != nullptr && *other_program != '\0' ? other_program : "gnuplot";
  const std::filesystem::path folder = std::filesystem::absolute(script).parent_path();
  const std::filesystem::path log = folder / (script.stem().string() + ".log");
  std::error_code ignored;
  int status = 0;
  try {
    // -d: without the user's own ~/.gnuplot, which would change the pictures.
    status = ChildProcess({program, "-d", script.filename().string()}, {.log = log, .folder = folder}).wait();
  } catch (const StartError& error) {
    if (!error.not_found()) throw;
    std::filesystem::remove(log, ignored);
    return GnuplotResult::not_installed;
  }
  if (status != 0) {
    throw RunError(script.string() + ": " + program + " failed: " + complaint_in(log) + "; its output is in " +
                   log.string());
  }
  std::filesystem::remove(log, ignored);
  return GnuplotResult::drawn;
}

std::string gnuplot_string(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'') quoted += '\'';
    quoted += c == '\n' ? ' ' : c;
  }
  return quoted + "'";
}

}  // namespace thalweg
