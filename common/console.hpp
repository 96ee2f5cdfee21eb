#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/run_folder.hpp"

// A program speaks to its user here: lines on the terminal as far as --quiet and --verbose let them through, all of them in the log of
// the run's folder, and with --json one object on stdout at the end.
namespace thalweg {

enum class Verbosity { quiet, normal, verbose };

void set_verbosity(Verbosity verbosity);
Verbosity verbosity();

/// Text for the user, of one or several lines, on stdout at once; a line end is added. Not shown with --quiet.
void say(std::string_view text);
/// The same on stderr: news of a program whose stdout is a result.
void say_beside(std::string_view text);
/// A detail, shown with --verbose only, on stderr.
void say_detail(std::string_view text);
/// "warning: text" on stderr, always.
void warn(std::string_view text);

/// Forgets the log of an earlier run in this folder.
void forget_log(const RunFolder& run);
/// From now on all this goes into the log of the run's folder too. Nothing happens where that cannot be written: the log is
/// there to help, and a full disk has its own message.
void keep_log(const RunFolder& run, const std::string& program);
/// A line for the log alone; `level` is a word such as "info" or "error".
void log_line(std::string_view level, std::string_view text);

/// With --json stdout is kept for one object, and what is said goes to stderr.
void answer_in_json();
bool answers_in_json();
/// The result, a JSON value as text.
void set_result(std::string json);

/// The errors that programs have told in the log of a run's folder since the solver was last started.
std::vector<std::string> errors_in_log(const RunFolder& run);

/// An error's message as a JSON object {"message", "file", "line", "cure"}, as far as it names these.
std::string error_json(const std::string& message);

/// Prints the result, or {"status": 2, "errors": [{"message", "file", "line", "cure"}]}, as far as an error names these. Nothing
/// without --json.
void print_answer(int status, const std::vector<std::string>& errors);

}  // namespace thalweg
