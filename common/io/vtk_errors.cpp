#include "common/io/vtk_errors.hpp"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <algorithm>
#include <mutex>

namespace thalweg {
namespace {

thread_local VtkErrors* collecting = nullptr;

/// Passes what VTK prints to who collects in this thread, and otherwise to where it went.
class Listener : public vtkOutputWindow {
 public:
  static Listener* New() { VTK_STANDARD_NEW_BODY(Listener); }

  void DisplayText(const char* text) override {
    if (collecting == nullptr) vtkOutputWindow::DisplayText(text);
  }
  void DisplayErrorText(const char* text) override {
    if (collecting != nullptr)
      collecting->add(text);
    else
      vtkOutputWindow::DisplayErrorText(text);
  }
};

void listen() {
  static std::once_flag once;
  std::call_once(once, [] {
    const vtkNew<Listener> listener;
    vtkOutputWindow::SetInstance(listener);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);  // it would print each error once more
  });
}

}  // namespace

VtkErrors::VtkErrors() : before_(collecting) {
  listen();
  collecting = this;
}

VtkErrors::~VtkErrors() {
  if (collecting == this) collecting = before_;
}

void VtkErrors::Execute(vtkObject* /*caller*/, unsigned long event, void* text) {
  if (event == vtkCommand::ErrorEvent) add(static_cast<const char*>(text));
}

void VtkErrors::add(const char* text) {
  if (any()) return;
  // VTK's text is "ERROR: In <source>, line N\n<class> (0x…): <message>\n\n".
  std::string message = text != nullptr ? text : "unknown error";
  if (const auto address = message.find("): "); address != std::string::npos) message.erase(0, address + 3);
  std::replace(message.begin(), message.end(), '\n', ' ');
  message.erase(message.find_last_not_of(" .;") + 1);
  constexpr std::size_t longest = 120;
  if (message.size() > longest) message = message.substr(0, longest) + "...";
  first_ = message.empty() ? "unknown error" : message;
}

}  // namespace thalweg
