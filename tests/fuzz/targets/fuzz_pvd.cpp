// Any bytes are a series of files in order of time, or are refused with InputError.
#include <cmath>
#include <cstdlib>

#include "common/error.hpp"
#include "common/io/series.hpp"
#include "input_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const auto entries = thalweg::read_series(thalweg::fuzz::input_file(data, size, ".pvd"));
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (!std::isfinite(entries[i].time) || entries[i].file.empty()) std::abort();
      if (i > 0 && entries[i].time < entries[i - 1].time) std::abort();
    }
  } catch (const thalweg::InputError& error) {
    if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
  }
  return 0;
}
