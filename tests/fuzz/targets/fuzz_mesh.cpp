// Any bytes are a surface or are refused with InputError; and every surface can be looked through for defects.
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>

#include "common/error.hpp"
#include "gencase/mesh_defects.hpp"
#include "gencase/mesh_reader.hpp"

namespace {

using thalweg::gencase::MeshFormat;

MeshFormat format_of(const std::string& bytes) {
  const std::string begin = bytes.substr(0, 12);
  if (begin.starts_with("ply")) return MeshFormat::ply;
  if (begin.find("OFF") != std::string::npos) return MeshFormat::off;
  if (begin.starts_with("v ") || begin.starts_with("#")) return MeshFormat::obj;
  return MeshFormat::stl;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  std::istringstream from(bytes);
  try {
    const auto surface = thalweg::gencase::triangulate(thalweg::gencase::read_mesh(from, format_of(bytes)).soup);
    constexpr std::size_t few = 100;  // self-intersections of many faces take their time
    if (surface.corners.size() < few)
      (void)thalweg::gencase::find_defects(surface, thalweg::gencase::SurfaceUse::body).text();
  } catch (const thalweg::InputError&) {
  }
  return 0;
}
