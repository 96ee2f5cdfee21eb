#include "postproc/display.hpp"

#include <X11/Xlib.h>

#include <cstdlib>

namespace thalweg {
namespace {

bool reachable() {
  ::Display* display = XOpenDisplay(nullptr);
  if (display == nullptr) return false;
  XCloseDisplay(display);
  return true;
}

}  // namespace

Display::Display() {
  if (reachable()) return;
  std::string number;
  try {
    // -noreset: else the server starts over when its last client leaves, as VTK does between two windows.
    server_.emplace(std::vector<std::string>{"Xvfb", "-displayfd", "3", "-noreset", "-screen", "0", "1280x1024x24",
                                             "-nolisten", "tcp"},
                    ChildSetup{.log = "/dev/null", .piped = 3});
    number = server_->read_line(std::chrono::seconds(15)).value_or("");
  } catch (const RunError&) {
    number.clear();  // a server that cannot be started is one that does not get ready
  }
  if (!number.empty()) setenv("DISPLAY", (":" + number).c_str(), 1);
  if (number.empty() || !reachable()) {
    why_not_ =
        "VTK draws on a display only, $DISPLAY names none that can be reached, and Xvfb, which would be one without "
        "a screen, does not start; apt-get install xvfb";
  }
}

}  // namespace thalweg
