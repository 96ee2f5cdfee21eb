#pragma once

#include <dlfcn.h>

#include <filesystem>
#include <string>
#include <utility>

#include "common/error.hpp"

namespace thalweg {

/// A module of the programs' own (installation.hpp), loaded to the end of the process.
class LoadedModule {
 public:
  /// `what` is named in messages, `cure` says what helps where it cannot be loaded. Throws RunError.
  LoadedModule(const std::filesystem::path& file, std::string what, std::string cure, int flags = RTLD_LOCAL)
      : what_(std::move(what)), cure_(std::move(cure)) {
    if (file.empty()) fail("not found beside the program");
    handle_ = dlopen(file.c_str(), RTLD_NOW | flags);
    if (handle_ == nullptr) fail(dlerror());
  }

  template <class Function>
  Function function(const char* symbol) const {
    void* const found = dlsym(handle_, symbol);
    if (found == nullptr) fail(dlerror());
    return reinterpret_cast<Function>(found);  // data pointer to function pointer: the conversion dlsym is made for
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    throw RunError("cannot load " + what_ + ": " + problem + "; " + cure_);
  }
  std::string what_;
  std::string cure_;
  void* handle_ = nullptr;
};

}  // namespace thalweg
