#include "common/io/vtk_errors.hpp"

#include <algorithm>

namespace thalweg {

void VtkErrors::Execute(vtkObject* /*caller*/, unsigned long event, void* text) {
  if (event != vtkCommand::ErrorEvent || any()) return;
  // VTK's text is "ERROR: In <source>, line N\n<class> (0x…): <message>\n\n".
  std::string message = text != nullptr ? static_cast<const char*>(text) : "unknown error";
  if (const auto address = message.find("): "); address != std::string::npos) message.erase(0, address + 3);
  std::replace(message.begin(), message.end(), '\n', ' ');
  message.erase(message.find_last_not_of(" .;") + 1);
  first_ = message;
}

}  // namespace thalweg
