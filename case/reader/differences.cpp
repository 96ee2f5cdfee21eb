#include "case/reader/differences.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <toml++/toml.h>

#include <map>
#include <sstream>

#include "case/reader/case_file.hpp"
#include "case/reader/toml.hpp"
#include "case/reader/write_tables.hpp"
#include "common/error.hpp"

namespace thalweg {
namespace {

using Values = std::map<std::string, std::string>;

/// A value as a reader would write it: numbers in their shortest form.
std::string text_of(const toml::node& node) {
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  std::ostringstream text;
  node.visit([&](const auto& typed) { text << typed; });
  return text.str();
}

/// Takes the values of a table under the names that a reader knows: entries of [[shape]] by their names.
void flatten(const toml::table& table, const std::string& prefix, Values& into) {
  for (const auto& [name, node] : table) {
    const std::string key = prefix + std::string(name.str());
    const toml::array* list = node.as_array();
    if (const toml::table* inner = node.as_table()) {
      flatten(*inner, key + ".", into);
    } else if (list != nullptr && list->is_array_of_tables()) {
      for (const toml::node& entry : *list) {
        flatten(*entry.as_table(), fmt::format("{}.{}.", key, name_of_entry(*entry.as_table())), into);
      }
    } else {
      into[key] = text_of(node);
    }
  }
}

Values values_of(const std::string& text) {
  try {
    Values values;
    flatten(toml::parse(text), "", values);
    return values;
  } catch (const toml::parse_error& error) {
    throw InputError(std::string("the text of a case cannot be read: ") + std::string(error.description()) +
                     "; fill the scene again with gencase");
  }
}

}  // namespace

std::string case_text(const Case& of) {
  std::ostringstream text;
  if (!of.file_hashes.empty()) fmt::print(text, "[files]\n");
  for (const auto& [name, hash] : of.file_hashes) fmt::print(text, "{} = {}\n", toml_text(name), toml_text(hash));
  write_tables(text, of);
  return text.str();
}

std::vector<KeyDifference> differences(const std::string& before, const std::string& now) {
  Values old_values = values_of(before);
  Values new_values = values_of(now);
  Values keys = old_values;
  keys.insert(new_values.begin(), new_values.end());
  std::vector<KeyDifference> found;
  for (const auto& [key, value] : keys) {
    if (old_values[key] != new_values[key]) found.push_back({key, old_values[key], new_values[key]});
  }
  return found;
}

}  // namespace thalweg
