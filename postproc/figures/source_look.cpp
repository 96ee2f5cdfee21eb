#include "postproc/figures/source_look.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace thalweg {

std::string dashes_of_source(const std::vector<ProfileSet>& sets, std::size_t s) {
  const auto nth_of_kind =
      static_cast<std::size_t>(std::count_if(sets.begin(), sets.begin() + static_cast<std::ptrdiff_t>(s),
                                             [&](const ProfileSet& earlier) { return earlier.kind == sets[s].kind; }));
  constexpr std::array mesh_dashes{"10,5", "2,4", "14,4,2,4"};
  constexpr std::array other_dashes{"12,4,2,4", "5,3", "2,7"};
  switch (sets[s].kind) {
    case SourceKind::mesh:
      return mesh_dashes[nth_of_kind % mesh_dashes.size()];
    case SourceKind::other:
      return other_dashes[nth_of_kind % other_dashes.size()];
    case SourceKind::run:
    case SourceKind::measured:
      break;
  }
  return "";
}

std::string source_style(const std::vector<ProfileSet>& sets, std::size_t s) {
  if (sets[s].kind == SourceKind::measured) return "with points lw 1.3 ps 0.7";
  const std::string dashes = dashes_of_source(sets, s);
  return dashes.empty() ? "with lines lw 2.2 dt 1" : fmt::format("with lines lw 1.8 dt ({})", dashes);
}

std::string folder_name_of(const std::string& label) {
  std::string name;
  for (const char c : label) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (plain) name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (!plain && !name.empty() && name.back() != '_') name += '_';
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  return name.empty() ? "source" : name;
}

}  // namespace thalweg
