#pragma once

#include <optional>
#include <string>

#include "common/process.hpp"

namespace thalweg {

/// A display for VTK to draw on: the one of $DISPLAY if it can be reached, else an Xvfb that lives as long as this
/// object and for which $DISPLAY is set. VTK itself would end the program where there is none.
class Display {
 public:
  Display();

  /// Empty when there is a display; else why not, and what to do.
  [[nodiscard]] const std::string& why_not() const { return why_not_; }

 private:
  std::optional<ChildProcess> server_;
  std::string why_not_;
};

}  // namespace thalweg
