#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <ostream>

#include "case/reader/case_file.hpp"
#include "case/reader/reference.hpp"

namespace thalweg {
namespace {

using Json = nlohmann::ordered_json;

Json quantity_schema(const std::string& unit) {
  return {{"type", "string"},
          {"pattern", "^\\s*[+-]?[0-9.]+([eE][+-]?[0-9]+)?\\s*[^\\s0-9+.-]"},
          {"examples", {fmt::format("1 {}", unit)}}};
}

Json value_schema(const KeyDeclaration& key) {
  switch (key.kind) {
    case KeyKind::quantity:
      return quantity_schema(key.unit);
    case KeyKind::number:
      return {{"type", "number"}, {"minimum", key.low}, {"maximum", key.high}};
    case KeyKind::integer:
      return {{"type", "integer"}, {"minimum", static_cast<int>(key.low)}, {"maximum", static_cast<int>(key.high)}};
    case KeyKind::flag:
      return {{"type", "boolean"}};
    case KeyKind::text:
      return {{"type", "string"}};
    case KeyKind::texts:
      return {{"type", "array"}, {"items", {{"type", "string"}}}};
    case KeyKind::point:
      return {{"type", "array"}, {"items", quantity_schema(key.unit)}, {"minItems", 2}, {"maxItems", 3}};
    case KeyKind::quantities:
      return {{"type", "array"}, {"items", quantity_schema(key.unit)}};
    case KeyKind::polygon:
      return {{"type", "array"},
              {"minItems", 3},
              {"items", {{"type", "array"}, {"items", quantity_schema(key.unit)}, {"minItems", 2}, {"maxItems", 2}}}};
    case KeyKind::choice:
      return {{"type", "string"}, {"enum", key.words}};
    case KeyKind::direction:
      return {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 2}, {"maxItems", 3}};
  }
  return {};
}

Json table_schema(const TableDeclaration& table) {
  Json properties = Json::object();
  Json needed = Json::array();
  const bool repeated = table.form == TableForm::repeated;
  if (repeated) needed.push_back("name");
  for (const KeyDeclaration& key : table.keys) {
    Json value = value_schema(key);
    std::string description = key.sentence;
    if (has_range(key)) description += fmt::format(" Range: {}.", range_text(key));
    description += fmt::format(" Default: {}.", default_text(key, table.form));
    value["description"] = description;
    properties[key.name] = value;
    if (key.required && !repeated) needed.push_back(key.name);
  }
  Json schema{{"type", "object"}, {"description", table.meaning}, {"properties", properties}};
  if (!needed.empty()) schema["required"] = needed;
  schema["additionalProperties"] = false;
  return schema;
}

// The place of a table among the properties of the file: "materials.water" is a property of "materials".
void add_table(Json& properties, const TableDeclaration& table) {
  const std::string group(group_of(table.name));
  if (!group.empty() && !properties.contains(group)) {
    properties[group] = {{"type", "object"}, {"properties", Json::object()}, {"additionalProperties", false}};
  }
  switch (table.form) {
    case TableForm::single:
      if (group.empty()) {
        properties[table.name] = table_schema(table);
      } else {
        properties[group]["properties"][table.name.substr(group.size() + 1)] = table_schema(table);
      }
      return;
    case TableForm::repeated:
      properties[table.name] = {{"type", "array"}, {"items", table_schema(table)}};
      return;
    case TableForm::by_name:
      properties[group]["additionalProperties"] = table_schema(table);
      return;
  }
}

}  // namespace

void write_key_schema(std::ostream& json, const Declarations& tables) {
  Json properties = Json::object();
  Json needed = Json::array();
  for (const TableDeclaration& table : tables) {
    add_table(properties, table);
    if (table.indispensable) needed.push_back(table.name);
  }
  const Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"},
                    {"title", "Thalweg case file"},
                    {"type", "object"},
                    {"properties", properties},
                    {"required", needed},
                    {"additionalProperties", false}};
  json << schema.dump(2) << '\n';
}

void write_key_schema(std::ostream& json) { write_key_schema(json, case_declarations()); }

}  // namespace thalweg
