#include "suite.hpp"

#include <toml++/toml.h>

#include <filesystem>
#include <stdexcept>

namespace thalweg::test {
namespace {

const std::filesystem::path suite_file = std::filesystem::path(THALWEG_SOURCE_DIR) / "cases/stability/suite.toml";

[[noreturn]] void refuse(const std::string& what) { throw std::runtime_error(suite_file.string() + ": " + what); }

std::string text(const toml::table& from, const char* key) {
  const auto value = from[key].value<std::string>();
  if (!value) refuse(std::string("a table without ") + key);
  return *value;
}

std::vector<std::string> texts(const toml::table& from, const char* key) {
  std::vector<std::string> out;
  if (const toml::array* list = from[key].as_array()) {
    for (const toml::node& entry : *list) out.push_back(entry.value<std::string>().value());
  }
  return out;
}

std::map<std::string, Bound> bounds(const toml::table* from) {
  std::map<std::string, Bound> out;
  if (from == nullptr) return out;
  for (const auto& [name, node] : *from) {
    const toml::table* table = node.as_table();
    if (table == nullptr) refuse("bound " + std::string(name.str()) + " is no table");
    Bound b;
    b.at_least = (*table)["at_least"].value_or(b.at_least);
    b.at_most = (*table)["at_most"].value_or(b.at_most);
    b.why = text(*table, "why");
    out[std::string(name.str())] = b;
  }
  return out;
}

}  // namespace

std::vector<StabilityCase> read_suite() {
  const toml::table file = toml::parse_file(suite_file.string());
  const auto everywhere = bounds(file["every_run"].as_table());
  const toml::array* cases = file["case"].as_array();
  if (cases == nullptr) refuse("no [[case]]");
  std::vector<StabilityCase> out;
  for (const toml::node& node : *cases) {
    const toml::table& row = *node.as_table();
    StabilityCase c;
    c.name = text(row, "name");
    c.scene = text(row, "scene");
    c.set = texts(row, "set");
    c.tries = text(row, "tries");
    c.fails = texts(row, "fails");
    c.bounds = bounds(row["bounds"].as_table());
    if (c.fails.empty()) c.bounds.insert(everywhere.begin(), everywhere.end());
    out.push_back(std::move(c));
  }
  return out;
}

}  // namespace thalweg::test
