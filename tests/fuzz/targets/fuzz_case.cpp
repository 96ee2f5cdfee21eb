// Any bytes are a case or are refused with InputError; nothing else may happen.
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "case/reader/case_file.hpp"
#include "common/error.hpp"

// UDUNITS loses the last word that it looked at in a unit that it refuses: some bytes, in its own code.
extern "C" const char* __lsan_default_suppressions() { return "leak:libudunits2"; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto file =
      std::filesystem::temp_directory_path() / ("thalweg_fuzz_" + std::to_string(getpid()) + ".toml");
  {
    std::ofstream to(file, std::ios::binary);
    to.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  }
  try {
    const thalweg::Case read = thalweg::read_case(file);
    (void)thalweg::hash_of(read);  // writes every value
  } catch (const thalweg::InputError&) {
  }
  std::filesystem::remove(file);
  return 0;
}
