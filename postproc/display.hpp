#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace thalweg {

/// A display for VTK to draw on: the one of $DISPLAY if it can be reached, else an Xvfb that lives as long as this
/// object and for which $DISPLAY is set. VTK itself would end the program where there is none.
class Display {
 public:
  Display();
  ~Display();
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;

  /// Empty when there is a display; else why not, and what to do.
  [[nodiscard]] const std::string& why_not() const { return why_not_; }

 private:
  pid_t server_ = 0;
  std::string why_not_;
};

/// Runs a program by name with its output in `log`; its exit status, 127 when there is no such program.
int run_program(const std::vector<std::string>& command, const std::filesystem::path& log);

}  // namespace thalweg
