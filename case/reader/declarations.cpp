#include "case/reader/declarations.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "case/case.hpp"
#include "case/reader/declare.hpp"

namespace thalweg {

std::vector<std::string> TableDeclaration::key_names() const {
  std::vector<std::string> names;
  for (const KeyDeclaration& key : keys) names.push_back(key.name);
  return names;
}

std::string TableDeclaration::title() const {
  switch (form) {
    case TableForm::single:
    case TableForm::by_name:
      return fmt::format("[{}]", name);
    case TableForm::repeated:
      return fmt::format("[[{}]]", name);
  }
  return name;
}

const Declarations& case_declarations() {
  static const Declarations tables = declare_tables<Case>();
  return tables;
}

const TableDeclaration* find_table(const Declarations& tables, std::string_view name) {
  const TableDeclaration* by_name = nullptr;
  for (const TableDeclaration& table : tables) {
    if (table.name == name) return &table;
    switch (table.form) {
      case TableForm::single:
      case TableForm::repeated:
        break;
      case TableForm::by_name:
        if (group_of(table.name) == group_of(name)) by_name = &table;
    }
  }
  return by_name;
}

std::vector<std::string> groups_of(const Declarations& tables) {
  std::vector<std::string> groups;
  for (const TableDeclaration& table : tables) {
    const std::string group(group_of(table.name));
    if (!group.empty() && std::find(groups.begin(), groups.end(), group) == groups.end()) groups.push_back(group);
  }
  return groups;
}

}  // namespace thalweg
