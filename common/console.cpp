#include "common/console.hpp"

#include <fmt/format.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/spdlog.h>

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>

#include "common/version.hpp"

namespace thalweg {
namespace {

// One program has one user.
struct Console {
  Verbosity verbosity = Verbosity::normal;
  bool json = false;
  std::string result;
  std::shared_ptr<spdlog::logger> log;
};

Console& console() {
  static Console one;
  return one;
}

void print(std::FILE* to, std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), to);
  if (!text.ends_with('\n')) std::fputc('\n', to);
  std::fflush(to);  // before the lines of a program that is started
}

std::string command_line() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  std::string text;
  for (std::string word; std::getline(file, word, '\0');) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// "case.toml:12: what; cure" in its parts. A message that is made otherwise has no file.
nlohmann::ordered_json error_object(const std::string& message) {
  nlohmann::ordered_json error{{"message", message}};
  static const std::regex place("^([^:]+):([0-9]+): ");
  if (std::smatch match; std::regex_search(message, match, place)) {
    error["file"] = match[1].str();
    error["line"] = std::stoi(match[2].str().substr(0, 9));
  }
  if (const auto cut = message.rfind("; "); cut != std::string::npos) error["cure"] = message.substr(cut + 2);
  return error;
}

}  // namespace

void set_verbosity(Verbosity verbosity) { console().verbosity = verbosity; }

Verbosity verbosity() { return console().verbosity; }

void say(std::string_view text) {
  log_line("info", text);
  if (console().verbosity != Verbosity::quiet) print(console().json ? stderr : stdout, text);
}

void say_beside(std::string_view text) {
  log_line("info", text);
  if (console().verbosity != Verbosity::quiet) print(stderr, text);
}

void say_detail(std::string_view text) {
  log_line("detail", text);
  if (console().verbosity == Verbosity::verbose) print(stderr, text);
}

void warn(std::string_view text) {
  log_line("warning", text);
  print(stderr, fmt::format("warning: {}", text));
}

void forget_log(const RunFolder& run) {
  std::error_code ignored;
  std::filesystem::remove(run.log(), ignored);
}

void keep_log(const RunFolder& run, const std::string& program) {
  try {
    auto sink = std::make_shared<spdlog::sinks::basic_file_sink_mt>(run.log().string());
    auto log = std::make_shared<spdlog::logger>(program, std::move(sink));
    log->set_error_handler([](const std::string&) {});
    log->set_pattern("%Y-%m-%d %H:%M:%S.%e %n %v");
    log->flush_on(spdlog::level::trace);
    console().log = std::move(log);
  } catch (const spdlog::spdlog_ex&) {
    return;
  }
  log_line("start", fmt::format("{}: {}", version(), command_line()));
}

void log_line(std::string_view level, std::string_view text) {
  if (!console().log) return;
  while (!text.empty()) {
    const auto end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    if (!line.empty()) console().log->info("{}: {}", level, line);
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
  }
}

void answer_in_json() { console().json = true; }

bool answers_in_json() { return console().json; }

void set_result(std::string json) { console().result = std::move(json); }

std::vector<std::string> errors_in_log(const RunFolder& run) {
  std::ifstream log(run.log());
  std::vector<std::string> errors;
  for (std::string line; std::getline(log, line);) {
    // "DATE TIME PROGRAM KIND: TEXT"
    constexpr std::size_t stamp = 24;
    const auto end = line.find(": ", stamp);
    if (end == std::string::npos) continue;
    const std::string_view who = std::string_view(line).substr(stamp, end - stamp);
    if (who == "solver start") errors.clear();
    if (who.ends_with(" error")) errors.push_back(line.substr(end + 2));
  }
  return errors;
}

std::string error_json(const std::string& message) { return error_object(message).dump(); }

void print_answer(int status, const std::vector<std::string>& errors) {
  if (!console().json) return;
  if (errors.empty()) {
    if (!console().result.empty()) print(stdout, console().result);
    return;
  }
  nlohmann::ordered_json answer{{"status", status}};
  for (const std::string& error : errors) answer["errors"].push_back(error_object(error));
  print(stdout, answer.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
}

}  // namespace thalweg
