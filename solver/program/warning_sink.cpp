#include "solver/program/warning_sink.hpp"

#include <spdlog/sinks/base_sink.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <memory>
#include <mutex>
#include <string>

#include "common/console.hpp"
#include "common/warnings.hpp"

namespace thalweg {
namespace {

const char* word_for(spdlog::level::level_enum level) {
  if (level >= spdlog::level::warn) return "warning";
  return level >= spdlog::level::info ? "info" : "detail";
}

class WarningSink : public spdlog::sinks::base_sink<std::mutex> {
 public:
  explicit WarningSink(WarningFile file) : file_(std::move(file)) {}

 protected:
  void sink_it_(const spdlog::details::log_msg& message) override {
    const std::string text(message.payload.data(), message.payload.size());
    log_line(word_for(message.level), text);
    if (message.level < spdlog::level::warn) return;
    const bool passing = text.starts_with("stopped by");  // a run that has not reached its end shows that itself
    if (!passing) file_.add(text);
  }
  void flush_() override {}

 private:
  WarningFile file_;
};

}  // namespace

void start_console() {
  if (answers_in_json()) spdlog::set_default_logger(spdlog::stderr_color_mt("thalweg-solver"));
  auto& logger = *spdlog::default_logger();
  logger.set_level(spdlog::level::debug);
  const auto shown = verbosity() == Verbosity::quiet     ? spdlog::level::warn
                     : verbosity() == Verbosity::verbose ? spdlog::level::debug
                                                         : spdlog::level::info;
  for (const auto& sink : logger.sinks()) sink->set_level(shown);
}

void keep_warnings(const RunFolder& run) {
  keep_log(run, "solver");
  spdlog::default_logger()->sinks().push_back(std::make_shared<WarningSink>(WarningFile(run, "solver")));
}

}  // namespace thalweg
