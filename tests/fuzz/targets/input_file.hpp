#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace thalweg::fuzz {

/// A file in memory, for readers that take a name; each process has its own.
inline std::filesystem::path input_file(const std::uint8_t* data, std::size_t size, const std::string& extension) {
  static const std::filesystem::path memory =
      std::filesystem::exists("/dev/shm") ? std::filesystem::path("/dev/shm") : std::filesystem::temp_directory_path();
  std::filesystem::path file = memory / ("thalweg_fuzz_" + std::to_string(getpid()) + extension);
  std::ofstream to(file, std::ios::binary);
  to.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  return file;
}

}  // namespace thalweg::fuzz
