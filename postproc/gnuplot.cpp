#include "postproc/gnuplot.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <span>
#include <sstream>
#include <vector>

#include "common/process.hpp"
#include "common/whole_file.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

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

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

constexpr std::string_view output_command = "set output '";

/// The files that a script draws, in its folder.
std::vector<fs::path> outputs_of(const fs::path& script, const std::string& text) {
  std::vector<fs::path> outputs;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(output_command) || !line.ends_with('\'')) continue;
    const std::string name = line.substr(output_command.size(), line.size() - output_command.size() - 1);
    outputs.push_back(fs::absolute(script).parent_path() / name);
  }
  return outputs;
}

/// The script that draws into another file.
std::string with_output(std::string text, const fs::path& output, const fs::path& other) {
  const std::string before = fmt::format("{}{}'", output_command, output.filename().string());
  const std::string after = fmt::format("{}{}'", output_command, other.filename().string());
  return text.replace(text.find(before), before.size(), after);
}

/// Runs the text of `script`, whatever files it draws into.
void draw(const fs::path& script, const std::string& text, std::chrono::seconds patience) {
  const char* other_program = std::getenv("THALWEG_GNUPLOT");
  const std::string program = other_program != nullptr && *other_program != '\0' ? other_program : "gnuplot";
  const fs::path folder = fs::absolute(script).parent_path();
  const fs::path log = folder / (script.stem().string() + ".log");
  const fs::path part = folder / fmt::format(".{}.{}.part.gp", script.stem().string(), getpid());
  std::ofstream(part) << text;
  std::error_code ignored;
  // -d: without the user's own ~/.gnuplot, which would change the pictures.
  try {
    ChildProcess gnuplot({program, "-d", part.filename().string()}, {.log = log, .folder = folder});
    const bool ended = gnuplot.ends_within(patience);
    if (!ended) gnuplot.end(SIGKILL);
    fs::remove(part, ignored);
    if (!ended) {
      throw ScriptHangs(fmt::format("{}: {} did not end within {} s and was ended; run it by hand", script.string(),
                                    program, patience.count()));
    }
    if (gnuplot.wait() != 0) {
      throw RunError(script.string() + ": " + program + " failed: " + complaint_in(log) + "; its output is in " +
                     log.string());
    }
  } catch (const StartError&) {
    fs::remove(part, ignored);
    fs::remove(log, ignored);
    throw;
  }
  fs::remove(log, ignored);
}

/// Draws, and puts each of the pictures in its place as a whole file.
void draw_whole(const fs::path& script, const std::string& text, std::span<const fs::path> outputs,
                std::chrono::seconds patience) {
  if (outputs.empty()) return draw(script, text, patience);
  write_whole_file(outputs.front(), [&](const fs::path& temporary) {
    draw_whole(script, with_output(text, outputs.front(), temporary), outputs.subspan(1), patience);
  });
}

}  // namespace

GnuplotResult run_gnuplot(const fs::path& script, std::chrono::seconds patience) {
  const std::string text = text_of(script);
  const std::vector<fs::path> outputs = outputs_of(script, text);
  try {
    draw_whole(script, text, outputs, patience);
  } catch (const StartError& error) {
    if (!error.not_found()) throw;
    return GnuplotResult::not_installed;
  }
  return GnuplotResult::drawn;
}

bool draw_pictures(const std::vector<fs::path>& scripts, std::vector<std::string>& warnings) {
  std::size_t drawn = 0;
  std::string problem;
  for (const fs::path& script : scripts) {
    try {
      if (run_gnuplot(script) == GnuplotResult::not_installed) {
        warnings.emplace_back("gnuplot is not installed, so there are no pictures; apt-get install gnuplot-nox");
        return true;
      }
      ++drawn;
    } catch (const ScriptHangs& error) {
      problem = error.what();
      break;
    } catch (const RunError& error) {
      if (problem.empty()) problem = error.what();
    }
  }
  if (drawn == scripts.size()) return true;
  warnings.push_back(fmt::format("{} of {} pictures are missing: {}", scripts.size() - drawn, scripts.size(), problem));
  return false;
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
