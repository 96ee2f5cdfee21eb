#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <ostream>

#include "case/reader/case_file.hpp"
#include "case/reader/keys.hpp"
#include "case/reader/tables.hpp"
#include "common/error.hpp"
#include "common/units.hpp"

namespace thalweg {
namespace {

using Json = nlohmann::ordered_json;

std::string kind_text(const KeyDeclaration& key) {
  switch (key.kind) {
    case KeyKind::quantity:
      return key.unit;
    case KeyKind::number:
      return "number";
    case KeyKind::integer:
      return "whole number";
    case KeyKind::flag:
      return "true or false";
    case KeyKind::text:
      return "text";
    case KeyKind::texts:
      return "list of texts";
    case KeyKind::point:
      return fmt::format("point, {}", key.unit);
    case KeyKind::quantities:
      return fmt::format("list of {}", key.unit);
    case KeyKind::polygon:
      return fmt::format("list of pairs of {}", key.unit);
    case KeyKind::choice:
      return "word";
    case KeyKind::direction:
      return "list of numbers";
  }
  return {};
}

bool has_range(const KeyDeclaration& key) {
  return key.kind == KeyKind::quantity || key.kind == KeyKind::quantities || key.kind == KeyKind::number ||
         key.kind == KeyKind::integer;
}

std::string range_text(const KeyDeclaration& key) {
  if (!has_range(key)) return {};
  if (key.unit.empty()) return fmt::format("{} to {}", key.low, key.high);
  return fmt::format("{} to {}", format_quantity(key.low, key.unit), format_quantity(key.high, key.unit));
}

// Whether a key without default is needed always, or only by some kinds of shape.
std::string default_text(const KeyDeclaration& key) {
  if (!key.required) return key.default_text;
  return key.is_list() ? "required by some kinds" : "required";
}

void explain_key(std::ostream& to, const KeyDeclaration& key) {
  fmt::print(to, "{}\n  {}", key.full_name(), kind_text(key));
  if (has_range(key)) fmt::print(to, ", {}", range_text(key));
  fmt::print(to, "; {}{}\n", key.required ? "" : "default ", default_text(key));
  fmt::print(to, "  {}\n", key.sentence);
  for (std::size_t i = 0; i < key.words.size(); ++i) {
    fmt::print(to, "    \"{}\": {}\n", key.words[i], key.word_sentences[i]);
  }
}

void explain_table(std::ostream& to, const TableDeclaration& table) {
  fmt::print(to, "[{}]  {}\n\n", table.name, table.meaning);
  for (const KeyDeclaration& key : table.keys) explain_key(to, key);
  fmt::print(to, "\n");
}

// ---------------------------------------------------------------------------------------------------------- the schema

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
  const bool is_list = table.name.starts_with('[');
  if (is_list) needed.push_back("name");
  for (const KeyDeclaration& key : table.keys) {
    Json value = value_schema(key);
    std::string description = key.sentence;
    if (has_range(key)) description += fmt::format(" Range: {}.", range_text(key));
    description += fmt::format(" Default: {}.", default_text(key));
    value["description"] = description;
    properties[key.name] = value;
    if (key.required && !is_list) needed.push_back(key.name);
  }
  Json schema{{"type", "object"}, {"description", table.meaning}, {"properties", properties}};
  if (!needed.empty()) schema["required"] = needed;
  schema["additionalProperties"] = false;
  return schema;
}

/// One row of what the two implementations of the three-state model differ in.
struct Reading {
  const char* what;
  const char* paper;
  const char* consistent;
};
constexpr Reading readings[] = {
    {"yield coefficient K", "2 sin(phi)/(sqrt3 (3 - sin(phi))), the coefficient of I1 used on p: 0.298 at 38 deg",
     "sin(phi), plane strain without dilation: 0.616 at 38 deg (model.yield_fit)"},
    {"yielded sediment", "consistency 1.54 Pa s^n, flow index 1.8: a syrup, which hides the erosion law",
     "consistency 1.5e-3 Pa s, flow index 1: a light slurry, which lets it act"},
    {"bed shear stress", "rho (kappa du/2)^2, du summed over the water without dividing by its share",
     "rho u*^2 by the logarithmic law from the mean of the water in reach (model.bed_shear)"},
    {"bed surface", "sediment-only density sum below 1250 of 1540 kg/m^3, 0.81 of a full bed",
     "below 0.85 (0.81 for smoothing_ratio > 1.55); grains that move have to be buried by 0.07 more"},
    {"deposit to bed load", "shear stress above the critical one of the slope", "the same"},
    {"bed load to deposit", "none: bed load never consolidates",
     "buried; or below 0.8 of the critical stress and slower than 0.01 sqrt(g d) for sqrt(d/g)"},
    {"bed load to suspended", "concentration <= 0.312 and speed above the lift velocity",
     "concentration <= 0.312, stress above critical, velocity along the bed's normal above the lift velocity"},
    {"suspended to bed load", "concentration > 0.312 or speed below the settling velocity",
     "concentration > 0.33; or slower than the settling velocity, sinking through the water, over bed load or deposit"},
    {"viscosity in suspension", "water's times exp[0.5 C/(1 - 39 C/64)], C share of sediment particles",
     "water's times exp[2.5 C/(1 - 39 C/64)], C volume share of grains (Vand)"},
};

void explain_implementations(std::ostream& to) {
  fmt::print(to, "What model.implementation changes (docs/theory.md, \"Three states\"):\n");
  for (const Reading& r : readings) {
    fmt::print(to, "  {}\n    paper:      {}\n    consistent: {}\n", r.what, r.paper, r.consistent);
  }
}

}  // namespace

void explain(std::ostream& to, const std::string& key) {
  std::vector<std::string> known;
  bool found = false;
  const TableDeclaration* whole_table = find_table(key);
  for (const TableDeclaration& table : case_declarations()) {
    known.push_back(table.name);
    if (key.empty() || whole_table == &table) {
      explain_table(to, table);
      found = true;
    }
    for (const KeyDeclaration& declared : table.keys) {
      known.push_back(declared.full_name());
      known.push_back(declared.name);
      const auto dot = key.rfind('.');
      const bool of_this_table = dot != std::string::npos && find_table(key.substr(0, dot)) == &table;
      if (key == declared.name || (of_this_table && key.substr(dot + 1) == declared.name)) {
        explain_key(to, declared);
        found = true;
      }
    }
  }
  if (key == "sediment" || key == "implementation") explain_implementations(to);
  if (found) return;
  const auto near = nearest(key, known);
  throw InputError(fmt::format("explain: there is no key or table {}; {}", key,
                               near ? fmt::format("did you mean {}?", *near) : "`thalweg explain` lists them all"));
}

void write_key_reference(std::ostream& markdown) {
  fmt::print(markdown, R"(# The case file

This page is generated from the declarations in `case/case.hpp` (target `docs`); `thalweg explain KEY` prints the same
in a terminal, and `case-file.schema.json` beside this page tells it to editors.

A case is a TOML file. Quantities are texts with a unit, read by UDUNITS: `spacing = "2 mm"`, `density = "1540 kg/m^3"`,
`friction_angle = "38 deg"`; only what has no dimension is a plain number. A point has one entry per dimension: `["x", "z"]`
in 2-D, `["x", "y", "z"]` in 3-D. A missing or wrong unit, an unknown key or a value out of range is an error with file
and line.

On the command line `--set table.key=value` overrides a key, `--set shape.NAME.key=value` one of a shape (likewise
`motion.NAME.key`, `gauge.NAME.key`, `line.NAME.key`) and `--set materials.NAME.key=value` one of a material.

Which geometry a shape needs follows from its kind: a box `from` and `to`; a cylinder `from`, `to` and `radius` (in 2-D
`center` and `radius`); a cone `from`, `to` and `radius`; a sphere `center` and `radius`; a prism `polygon` and, in 3-D,
`extent`; a mesh `file`; a bathymetry `file` and `base`; a level `level`; a layer `thickness`; a union, difference or
intersection `of`. A key that means nothing for a shape is an error. `docs/geometry.md` shows each of them.
)");
  for (const TableDeclaration& table : case_declarations()) {
    const bool repeated = table.name.starts_with('[');
    fmt::print(markdown, "\n## `[{}]`\n\n{}\n\n", table.name, table.meaning);
    fmt::print(markdown, "| key | value | default | range | meaning |\n|---|---|---|---|---|\n");
    for (const KeyDeclaration& key : table.keys) {
      std::string meaning = key.sentence;
      for (std::size_t i = 0; i < key.words.size(); ++i) {
        meaning += fmt::format("<br>`\"{}\"`: {}", key.words[i], key.word_sentences[i]);
      }
      fmt::print(markdown, "| `{}` | {} | {} | {} | {} |\n", key.name, kind_text(key),
                 key.required ? (repeated ? "by kind" : "**required**") : fmt::format("`{}`", key.default_text),
                 range_text(key), meaning);
    }
  }
}

void write_key_schema(std::ostream& json) {
  Json properties = Json::object();
  Json materials{{"type", "object"}, {"properties", Json::object()}};
  for (const TableDeclaration& table : case_declarations()) {
    if (table.name == shape_heading.name) {
      properties["shape"] = {{"type", "array"}, {"items", table_schema(table)}};
    } else if (table.name == motion_heading.name || table.name == gauge_heading.name ||
               table.name == line_heading.name) {
      const std::string list = table.name.substr(1, table.name.size() - 2);
      properties[list] = {{"type", "array"}, {"items", table_schema(table)}};
    } else if (table.name == water_heading.name) {
      materials["properties"]["water"] = table_schema(table);
    } else if (table.name == sediment_heading.name) {
      materials["additionalProperties"] = table_schema(table);
      properties["materials"] = materials;
    } else {
      properties[table.name] = table_schema(table);
    }
  }
  const Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"},
                    {"title", "Thalweg case file"},
                    {"type", "object"},
                    {"properties", properties},
                    {"required", {"domain", "shape", "numerics", "output"}},
                    {"additionalProperties", false}};
  json << schema.dump(2) << '\n';
}

}  // namespace thalweg
