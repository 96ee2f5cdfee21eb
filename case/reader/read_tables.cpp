#include "case/reader/read_tables.hpp"

namespace thalweg {

GivenWords given_words(const toml::table& root, const std::filesystem::path& folder, const CaseOrigins& origins) {
  GivenWords given{folder, origins.resolved, {}};
  for (const auto& [table_name, node] : root) {
    const toml::table* table = node.as_table();
    if (table == nullptr) continue;
    for (const auto& [key, value] : *table) {
      const toml::value<std::string>* text = value.as_string();
      if (text == nullptr) continue;
      given.words[fmt::format("{}.{}", table_name.str(), key.str())] = {text->get(), where_is(value, origins.file)};
    }
  }
  return given;
}

}  // namespace thalweg
