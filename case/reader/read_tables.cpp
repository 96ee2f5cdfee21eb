#include "case/reader/read_tables.hpp"

namespace thalweg {

GivenWords given_words(const toml::table& root, const std::filesystem::path& folder, const CaseOrigins& origins) {
  GivenWords given{folder, origins.resolved, {}};
  for (const auto& [table_name, node] : root) {
    const toml::table* table = node.as_table();
    if (table_name.str() == "inlet") given.words["inlet"] = {"inlet", where_is(node, origins.file)};
    if (table == nullptr) continue;
    for (const auto& [key, value] : *table) {
      std::string text;
      if (const auto* word = value.as_string()) text = word->get();
      if (const auto* number = value.as_integer()) text = std::to_string(number->get());
      if (const auto* number = value.as_floating_point()) text = fmt::format("{}", number->get());
      if (text.empty()) continue;
      given.words[fmt::format("{}.{}", table_name.str(), key.str())] = {text, where_is(value, origins.file)};
    }
  }
  return given;
}

}  // namespace thalweg
