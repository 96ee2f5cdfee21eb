#pragma once

#include <vtkCommand.h>
#include <vtkNew.h>

#include <string>

namespace thalweg {

/// Collects the errors that a VTK object would print to stderr, so that they can become one message of ours.
class VtkErrors : public vtkCommand {
 public:
  static VtkErrors* New() { return new VtkErrors; }
  void Execute(vtkObject* caller, unsigned long event, void* text) override;

  [[nodiscard]] bool any() const { return !first_.empty(); }
  /// The first message, on one line and without VTK's source position.
  [[nodiscard]] const std::string& first() const { return first_; }

 private:
  std::string first_;
};

}  // namespace thalweg
