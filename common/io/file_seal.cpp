#include "common/io/file_seal.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <fstream>
#include <vector>

#include "common/error.hpp"

namespace thalweg {
namespace {

constexpr std::string_view opening = "<!-- crc32 ";
constexpr std::string_view closing = " of all above -->\n";
constexpr std::size_t digits = 8;
constexpr std::size_t seal_size = opening.size() + digits + closing.size();

std::string seal_with(unsigned long checksum) { return fmt::format("{}{:08x}{}", opening, checksum, closing); }

unsigned long add_to(unsigned long checksum, std::string_view bytes) {
  return crc32_z(checksum, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
}

}  // namespace

void Seal::add(std::string_view part) { checksum_ = add_to(checksum_, part); }

std::string Seal::text() const { return seal_with(checksum_); }

std::string seal_of(std::string_view contents) { return seal_with(add_to(0, contents)); }

SealState seal_state(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  const auto size = stream ? static_cast<std::streamoff>(stream.tellg()) : std::streamoff{-1};
  if (size < 0) throw InputError(file.string() + ": cannot be opened; check the name and the permissions");
  const auto sealed = size - static_cast<std::streamoff>(seal_size);
  if (sealed < 0) return SealState::none;
  std::string last(seal_size, '\0');
  stream.seekg(sealed);
  stream.read(last.data(), static_cast<std::streamsize>(last.size()));
  if (!last.starts_with(opening) || !last.ends_with(closing)) return SealState::none;

  stream.seekg(0);
  unsigned long checksum = 0;
  std::vector<char> part(1 << 20);
  for (std::streamoff left = sealed; left > 0 && stream;) {
    stream.read(part.data(), std::min<std::streamoff>(left, static_cast<std::streamoff>(part.size())));
    checksum = add_to(checksum, {part.data(), static_cast<std::size_t>(stream.gcount())});
    left -= stream.gcount();
  }
  return stream && last == seal_with(checksum) ? SealState::whole : SealState::broken;
}

}  // namespace thalweg
