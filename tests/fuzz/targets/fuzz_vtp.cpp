// Any bytes are a particle file and a surface, or are refused with InputError of one line, before VTK prints anything.
#include <cstdlib>

#include "common/error.hpp"
#include "common/io/particle_file.hpp"
#include "common/io/surface_file.hpp"
#include "input_file.hpp"

namespace {

template <class Read>
void refuse_or(const Read& read) {
  constexpr std::size_t longest_message = 300 + 64;
  try {
    read();
  } catch (const thalweg::InputError& error) {
    const std::string_view message = error.what();
    if (message.size() > longest_message || message.find('\n') != std::string_view::npos) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = thalweg::fuzz::input_file(data, size, ".vtp");
  refuse_or([&] { (void)thalweg::read_particle_info(file); });
  refuse_or([&] { (void)thalweg::read_particles(file); });
  refuse_or([&] {
    const auto soup = thalweg::read_vtp_surface(file);
    for (const auto& polygon : soup.polygons)
      for (const std::size_t corner : polygon)
        if (corner >= soup.points.size()) std::abort();
  });
  return 0;
}
