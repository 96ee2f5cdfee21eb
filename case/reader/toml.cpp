#include "case/reader/toml.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <vector>

#include "common/error.hpp"

namespace thalweg {
namespace {

constexpr std::string_view override_mark = "--set ";

toml::table parse_toml(const std::string& content, const std::string& name) {
  try {
    return toml::parse(content, name);
  } catch (const toml::parse_error& error) {
    reject_case(fmt::format("{}:{}", name, error.source().begin.line), fmt::format("not TOML: {}", error.description()),
                "correct the line");
  }
}

// The value of an override: TOML where it is TOML, otherwise a text, since a shell takes the quotes away.
toml::table parse_override_value(const std::string& value, const std::string& source) {
  try {
    return toml::parse("value = " + value, source);
  } catch (const toml::parse_error& error) {
    if (value.starts_with('[') || value.starts_with('"') || value.starts_with('\'')) {
      reject_case(source, fmt::format("the value is not TOML: {}", error.description()), "correct it");
    }
  }
  std::ostringstream quoted;
  quoted << toml::value<std::string>(value);
  return toml::parse("value = " + quoted.str(), source);
}

// The entry of a repeated table; `list` is its name.
toml::table& entry_to_override(toml::table& root, const std::string& list, const std::string& name,
                               const std::string& source) {
  std::vector<std::string> names;
  if (toml::array* entries = root[list].as_array()) {
    for (toml::node& entry : *entries) {
      if (!entry.is_table()) continue;
      names.push_back(name_of_entry(*entry.as_table()));
      if (names.back() == name) return *entry.as_table();
    }
  }
  reject_case(source, fmt::format("there is no {} \"{}\"", list, name),
              fmt::format("the {}s are {}", list, fmt::join(names, ", ")));
}

// The table `name` of a group, whose name is a plural. Single tables, which a file may leave out, are made.
toml::table& group_to_override(toml::table& root, const std::string& group, const std::string& name, bool may_be_made,
                               const std::string& source) {
  toml::table* members = root[group].as_table();
  if (members == nullptr && may_be_made) members = root.insert(group, toml::table{}).first->second.as_table();
  if (members != nullptr && may_be_made) members->insert(name, toml::table{});
  if (members != nullptr && members->get(name) != nullptr && members->get(name)->is_table()) {
    return *members->get(name)->as_table();
  }
  std::vector<std::string> names;
  if (members != nullptr) {
    for (const auto& [known, ignored] : *members) names.emplace_back(known.str());
  }
  reject_case(source, fmt::format("there is no {} \"{}\"", group.substr(0, group.size() - 1), name),
              fmt::format("the {} are {}", group, fmt::join(names, ", ")));
}

// The words that may stand for TABLE in an override TABLE.NAME.key=value.
std::vector<std::string> names_with_entries(const Declarations& tables) {
  std::vector<std::string> names;
  for (const TableDeclaration& table : tables) {
    if (table.form == TableForm::repeated) names.push_back(table.name);
  }
  for (const std::string& group : groups_of(tables)) names.push_back(group);
  return names;
}

toml::table& table_to_override(toml::table& root, const std::vector<std::string>& key, const Declarations& tables,
                               const std::string& source) {
  const std::vector<std::string> with_entries = names_with_entries(tables);
  const bool has_entries =
      !key.empty() && std::find(with_entries.begin(), with_entries.end(), key[0]) != with_entries.end();
  if (key.size() == 3 && has_entries) {
    const TableDeclaration* table = find_table(tables, key[0]);
    if (table != nullptr) return entry_to_override(root, key[0], key[1], source);
    const TableDeclaration* member = find_table(tables, key[0] + "." + key[1]);
    const bool is_single = member != nullptr && member->form == TableForm::single;
    return group_to_override(root, key[0], key[1], is_single, source);
  }
  if (key.size() != 2 || has_entries) {
    reject_case(
        source, "not a key",
        fmt::format("write table.key=value, or TABLE.NAME.key=value where TABLE is one of {}; `thalweg explain` "
                    "lists the keys",
                    fmt::join(with_entries, ", ")));
  }
  if (root.get(key[0]) == nullptr) root.insert(key[0], toml::table{});
  if (!root.get(key[0])->is_table())
    reject_case(where_is(*root.get(key[0]), ""), key[0] + " is no table", "write [" + key[0] + "]");
  return *root.get(key[0])->as_table();
}

}  // namespace

void reject_case(const std::string& where, const std::string& what, const std::string& cure) {
  throw InputError(fmt::format("{}: {}; {}", where, what, cure));
}

std::string where_is(const toml::node& node, const std::string& file) {
  const toml::source_region& source = node.source();
  if (!source.path) return file + ":1";
  if (source.path->starts_with(override_mark)) return *source.path;
  return fmt::format("{}:{}", *source.path, source.begin.line);
}

std::string name_of_entry(const toml::table& entry) { return entry["name"].value_or(std::string()); }

toml::table parse_case_toml(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  if (!stream) reject_case(file.string(), "cannot be read", "check the name and the permissions");
  return parse_toml(content.str(), file.string());
}

void apply_override(toml::table& root, const std::string& text, const Declarations& tables) {
  const std::string source = std::string(override_mark) + text;
  const auto equals = text.find('=');
  if (equals == std::string::npos) reject_case(source, "has no value", "write --set table.key=value");
  std::vector<std::string> key;
  std::istringstream parts(text.substr(0, equals));
  for (std::string part; std::getline(parts, part, '.');) key.push_back(part);

  toml::table& table = table_to_override(root, key, tables, source);
  toml::table parsed = parse_override_value(text.substr(equals + 1), source);
  // Moved, not copied: a copied node forgets where it comes from.
  parsed.get("value")->visit([&](auto& value) { table.insert_or_assign(key.back(), std::move(value)); });
}

}  // namespace thalweg
