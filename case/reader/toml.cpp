#include "case/reader/toml.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

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

// `list` is "shape", "gauge" …
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

toml::table& material_to_override(toml::table& root, const std::string& name, const std::string& source) {
  toml::table* materials = root["materials"].as_table();
  if (materials == nullptr && name == "water")
    materials = root.insert("materials", toml::table{}).first->second.as_table();
  if (materials != nullptr && name == "water") materials->insert(name, toml::table{});
  if (materials != nullptr && materials->get(name) != nullptr && materials->get(name)->is_table()) {
    return *materials->get(name)->as_table();
  }
  std::vector<std::string> names;
  if (materials != nullptr) {
    for (const auto& [known, ignored] : *materials) names.emplace_back(known.str());
  }
  reject_case(source, fmt::format("there is no material \"{}\"", name),
              fmt::format("the materials are {}", fmt::join(names, ", ")));
}

toml::table& table_to_override(toml::table& root, const std::vector<std::string>& key, const std::string& source) {
  const bool is_list = !key.empty() && is_list_of_tables(key[0]);
  if (key.size() == 3 && is_list) return entry_to_override(root, key[0], key[1], source);
  if (key.size() == 3 && key[0] == "materials") return material_to_override(root, key[1], source);
  if (key.size() != 2 || is_list || key[0] == "materials") {
    reject_case(
        source, "not a key",
        "write table.key=value, shape.NAME.key=value or materials.NAME.key=value; `thalweg explain` lists the keys");
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

bool is_list_of_tables(std::string_view name) {
  return name == "shape" || name == "motion" || name == "gauge" || name == "line";
}

toml::table parse_case_toml(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  if (!stream) reject_case(file.string(), "cannot be read", "check the name and the permissions");
  return parse_toml(content.str(), file.string());
}

void apply_override(toml::table& root, const std::string& text) {
  const std::string source = std::string(override_mark) + text;
  const auto equals = text.find('=');
  if (equals == std::string::npos) reject_case(source, "has no value", "write --set table.key=value");
  std::vector<std::string> key;
  std::istringstream parts(text.substr(0, equals));
  for (std::string part; std::getline(parts, part, '.');) key.push_back(part);

  toml::table& table = table_to_override(root, key, source);
  toml::table parsed = parse_override_value(text.substr(equals + 1), source);
  // Moved, not copied: a copied node forgets where it comes from.
  parsed.get("value")->visit([&](auto& value) { table.insert_or_assign(key.back(), std::move(value)); });
}

}  // namespace thalweg
