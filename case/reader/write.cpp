#include <fmt/format.h>
#include <fmt/ostream.h>
#include <toml++/toml.h>

#include <cstdint>
#include <ostream>
#include <sstream>

#include "case/reader/case_file.hpp"
#include "case/reader/write_tables.hpp"
#include "common/version.hpp"
#include "common/whole_file.hpp"

namespace thalweg {

std::string toml_text(const std::string& text) {
  std::ostringstream stream;
  stream << toml::value<std::string>(text);
  return stream.str();
}

void write_case(const std::filesystem::path& file, const Case& resolved) {
  write_whole_text(file, [&](std::ostream& to) {
    fmt::print(to, "# The case as it was resolved: every key with its value. Written by thalweg {}.\n", version());
    fmt::print(to, "\n[resolved]\nfolder = {}\n", toml_text(resolved.folder.string()));
    if (!resolved.file_hashes.empty()) fmt::print(to, "\n[resolved.files]\n");
    for (const auto& [name, hash] : resolved.file_hashes) {
      fmt::print(to, "{} = {}\n", toml_text(name), toml_text(hash));
    }
    write_tables(to, resolved);
  });
}

std::string hash_of_text(std::string_view text) {
  // FNV-1a, 64 bit (Fowler, Noll and Vo): told apart are cases, not attackers.
  std::uint64_t hash = 14695981039346656037U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
  return fmt::format("{:016x}", hash);
}

std::string hash_of(const Case& resolved) {
  std::ostringstream text;
  write_tables(text, resolved);
  for (const auto& [name, hash] : resolved.file_hashes) fmt::print(text, "{} {}\n", name, hash);
  return hash_of_text(text.str());
}

}  // namespace thalweg
