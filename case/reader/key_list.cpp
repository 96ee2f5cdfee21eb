#include <algorithm>
#include <nlohmann/json.hpp>

#include "case/field_words.hpp"
#include "case/reader/case_file.hpp"
#include "case/reader/reference.hpp"
#include "common/error.hpp"

namespace thalweg {
namespace {

using Json = nlohmann::ordered_json;

std::string kind_word(KeyKind kind) {
  switch (kind) {
    case KeyKind::quantity:
      return "quantity";
    case KeyKind::number:
      return "number";
    case KeyKind::integer:
      return "whole number";
    case KeyKind::flag:
      return "flag";
    case KeyKind::text:
      return "text";
    case KeyKind::texts:
      return "texts";
    case KeyKind::point:
      return "point";
    case KeyKind::quantities:
      return "quantities";
    case KeyKind::polygon:
      return "polygon";
    case KeyKind::choice:
      return "word";
    case KeyKind::direction:
      return "direction";
  }
  return {};
}

Json key_object(const KeyDeclaration& key) {
  Json object{{"key", key.full_name()}, {"kind", kind_word(key.kind)}};
  if (!key.unit.empty()) object["unit"] = key.unit;
  object["required"] = key.required;
  if (!key.required) object["default"] = key.default_text;
  if (has_range(key)) {
    object["lowest"] = key.low;
    object["highest"] = key.high;
  }
  object["meaning"] = key.sentence;
  for (std::size_t i = 0; i < key.words.size(); ++i)
    object["words"].push_back({{"word", key.words[i]}, {"meaning", key.word_sentences[i]}});
  return object;
}

/// True if a key is asked for by its name, its full name, its table, or nothing.
bool is_asked(const std::string& asked, const TableDeclaration& table, const KeyDeclaration& key) {
  if (asked.empty() || asked == key.name || asked == key.full_name()) return true;
  if (find_table(case_declarations(), asked) == &table) return true;
  const auto dot = asked.rfind('.');
  return dot != std::string::npos && asked.substr(dot + 1) == key.name &&
         find_table(case_declarations(), asked.substr(0, dot)) == &table;
}

}  // namespace

std::string explain_json(const std::string& key) {
  Json object = Json::object();
  std::vector<std::string> asked{key};
  const auto add_keys = [&] {
    object["keys"] = Json::array();
    for (const TableDeclaration& table : case_declarations()) {
      for (const KeyDeclaration& declared : table.keys) {
        const auto is_meant = [&](const std::string& word) { return is_asked(word, table, declared); };
        if (std::any_of(asked.begin(), asked.end(), is_meant)) object["keys"].push_back(key_object(declared));
      }
    }
  };
  add_keys();
  if (object["keys"].empty()) {
    const FieldWord* entry = find_field_word(key);
    if (entry == nullptr)
      throw InputError("explain: there is no key or table " + key + "; `thalweg explain` lists them all");
    object["answer"] = entry->answer;
    asked = entry->keys;
    add_keys();
  }
  return object.dump(2);
}

std::vector<std::string> key_names() {
  std::vector<std::string> names;
  for (const TableDeclaration& table : case_declarations()) {
    if (table.form != TableForm::single) continue;
    for (const KeyDeclaration& key : table.keys) names.push_back(key.full_name());
  }
  return names;
}

}  // namespace thalweg
