#include "solver/program/warning_sink.hpp"

#include <spdlog/sinks/base_sink.h>
#include <spdlog/spdlog.h>

#include <memory>
#include <mutex>
#include <string>

#include "common/warnings.hpp"

namespace thalweg {
namespace {

class WarningSink : public spdlog::sinks::base_sink<std::mutex> {
 public:
  explicit WarningSink(WarningFile file) : file_(std::move(file)) { set_level(spdlog::level::warn); }

 protected:
  void sink_it_(const spdlog::details::log_msg& message) override {
    const std::string text(message.payload.data(), message.payload.size());
    const bool passing = text.starts_with("stopped by");  // a run that has not reached its end shows that itself
    if (!passing) file_.add(text);
  }
  void flush_() override {}

 private:
  WarningFile file_;
};

}  // namespace

void keep_warnings(const RunFolder& run) {
  spdlog::default_logger()->sinks().push_back(std::make_shared<WarningSink>(WarningFile(run, "solver")));
}

}  // namespace thalweg
