#pragma once

#include <vtkCommand.h>
#include <vtkNew.h>

#include <string>

namespace thalweg {

/// Collects the errors that VTK would print to stderr, so that they can become one message of ours: those of objects
/// that it observes, and while it lives those of all other objects of its thread. Their warnings are left out.
class VtkErrors : public vtkCommand {
 public:
  static VtkErrors* New() { return new VtkErrors; }
  void Execute(vtkObject* caller, unsigned long event, void* text) override;
  void add(const char* text);

  [[nodiscard]] bool any() const { return !first_.empty(); }
  /// The first message, on one line, shortened, and without VTK's source position.
  [[nodiscard]] const std::string& first() const { return first_; }

 protected:
  VtkErrors();
  ~VtkErrors() override;

 private:
  std::string first_;
  VtkErrors* before_;  // who collected in this thread before
};

}  // namespace thalweg
