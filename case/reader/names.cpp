#include "case/reader/names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <vector>

#include "case/field_words.hpp"
#include "case/nearest.hpp"
#include "case/reader/toml.hpp"

namespace thalweg {
namespace {

class NameCheck {
 public:
  NameCheck(const Declarations& tables, const std::string& file, Mistakes& mistakes)
      : tables_(tables), file_(file), mistakes_(mistakes) {}

  void all(const toml::table& root) const {
    const std::vector<std::string> groups = groups_of(tables_);
    for (const auto& [key, node] : root) {
      const std::string name(key.str());
      if (name == resolved_table) continue;
      const bool one_word = group_of(name).empty();  // not ["materials.water"]
      if (std::find(groups.begin(), groups.end(), name) != groups.end()) {
        group(name, node);
      } else if (const TableDeclaration* declared = find_table(tables_, name); declared != nullptr && one_word) {
        table(*declared, name, node);
      } else {
        mistakes_.attempt([&, &value = node] { reject_unknown_table(name, value); });
      }
    }
  }

 private:
  void table(const TableDeclaration& declared, const std::string& name, const toml::node& node) const {
    switch (declared.form) {
      case TableForm::single:
      case TableForm::by_name:
        return keys(as_table(node, name), declared, name);
      case TableForm::repeated:
        return list(node, declared);
    }
  }

  // Tables under one name, such as [materials.water] and [materials.pvc].
  void group(const std::string& name, const toml::node& node) const {
    for (const auto& [entry, values] : as_table(node, name)) {
      const std::string path = fmt::format("{}.{}", name, entry.str());
      const TableDeclaration* declared = find_table(tables_, path);
      if (declared == nullptr) {
        mistakes_.attempt([&, &value = values] { reject_unknown_table(path, value); });
        continue;
      }
      keys(as_table(values, path), *declared, path);
    }
  }

  void list(const toml::node& node, const TableDeclaration& declared) const {
    const std::string& name = declared.name;
    if (!node.is_array() || !node.as_array()->is_homogeneous(toml::node_type::table)) {
      reject_case(where(node), fmt::format("{} is no list of tables", name),
                  fmt::format("write [[{0}]] above each {0}", name));
    }
    std::set<std::string> used;
    for (const toml::node& entry : *node.as_array()) {
      const std::string entry_name = name_of(entry, name);
      if (!used.insert(entry_name).second) {
        reject_case(where(*entry.as_table()->get("name")), fmt::format("the name \"{}\" is used twice", entry_name),
                    fmt::format("rename one of the {}s", name));
      }
      keys(*entry.as_table(), declared, fmt::format("{}.{}", name, entry_name));
    }
  }

  [[nodiscard]] std::string name_of(const toml::node& entry, const std::string& list_name) const {
    const toml::node* node = entry.as_table()->get("name");
    if (node == nullptr) reject_case(where(entry), fmt::format("a {} has no name", list_name), "add name = \"...\"");
    const std::string name = name_of_entry(*entry.as_table());
    if (name.empty()) {
      reject_case(where(*node), fmt::format("a {}'s name must be a text", list_name), "write name = \"...\"");
    }
    return name;
  }

  // `path` is how the user writes the table in an override.
  void keys(const toml::table& table, const TableDeclaration& declared, const std::string& path) const {
    const std::vector<std::string> known = declared.key_names();
    for (const auto& [name, node] : table) {
      const std::string key(name.str());
      if (std::find(known.begin(), known.end(), key) != known.end()) continue;
      const bool already_named = where(node).starts_with("--set ");
      mistakes_.note_unknown_key(path);
      mistakes_.attempt([&, &value = node] {
        reject_case(where(value), already_named ? "unknown key" : fmt::format("unknown key {}.{}", path, key),
                    cure_of(key, known, path));
      });
    }
  }

  [[nodiscard]] std::string cure_of(const std::string& key, const std::vector<std::string>& known,
                                    const std::string& path) const {
    const std::vector<std::string> of_this_table = with_part(key, known);
    if (!of_this_table.empty())
      return fmt::format("did you mean {0}.{1}?", path, fmt::join(of_this_table, fmt::format(" or {}.", path)));
    if (const auto elsewhere = key_elsewhere(key); !elsewhere.empty()) return elsewhere;
    if (const auto near = nearest(key, known)) return fmt::format("did you mean {}.{}?", path, *near);
    if (const std::string meant = by_field_word(key, known); !meant.empty())
      return fmt::format("did you mean {}.{}?", path, meant);
    constexpr std::size_t most = 20;  // more do not fit into a line
    if (known.size() > most) return fmt::format("`thalweg explain {}` lists the keys", path);
    return fmt::format("the keys of {} are {}", path, fmt::join(known, ", "));
  }

  // The key that a word of the field stands for, such as grain_diameter for d50; empty if this table has none.
  static std::string by_field_word(const std::string& word, const std::vector<std::string>& known) {
    const FieldWord* entry = find_field_word(word);
    if (entry == nullptr) return {};
    for (const std::string& key : entry->keys) {
      const std::string name = key.substr(key.rfind('.') + 1);
      if (std::find(known.begin(), known.end(), name) != known.end()) return name;
    }
    return {};
  }

  // The keys of which a word is a part: "density" of "grain_density".
  static std::vector<std::string> with_part(const std::string& word, const std::vector<std::string>& known) {
    std::vector<std::string> found;
    for (const std::string& key : known)
      if (key.ends_with("_" + word) || key.starts_with(word + "_")) found.push_back(key);
    return found;
  }

  // The cure where some table has a key of this name; empty otherwise.
  [[nodiscard]] std::string key_elsewhere(const std::string& name) const {
    std::string cure;
    for (const TableDeclaration& table : tables_) {
      for (const KeyDeclaration& key : table.keys) {
        if (key.name != name) continue;
        cure = fmt::format("did you mean {}?", key.full_name());
        mistakes_.note_unknown_key(table.name);
      }
    }
    return cure;
  }

  // The names that may stand at the top of a case file.
  [[nodiscard]] std::vector<std::string> known_tables() const {
    std::vector<std::string> repeated;
    std::vector<std::string> single;
    for (const TableDeclaration& table : tables_) {
      if (!group_of(table.name).empty()) continue;
      (table.form == TableForm::repeated ? repeated : single).push_back(table.name);
    }
    for (const std::string& group : groups_of(tables_)) repeated.push_back(group);
    repeated.insert(repeated.end(), single.begin(), single.end());
    return repeated;
  }

  [[noreturn]] void reject_unknown_table(const std::string& name, const toml::node& node) const {
    const std::vector<std::string> known = known_tables();
    const bool is_table = node.is_table() || node.is_array();
    std::string cure = fmt::format("the tables are {}", fmt::join(known, ", "));
    if (const auto near = nearest(name, known)) {
      cure = fmt::format("did you mean {}?", *near);
      mistakes_.note_unknown_key(*near);
    }
    if (const auto elsewhere = key_elsewhere(name); !is_table && !elsewhere.empty()) cure = elsewhere;
    reject_case(where(node), fmt::format("unknown {} {}", is_table ? "table" : "key", name), cure);
  }

  [[nodiscard]] const toml::table& as_table(const toml::node& node, const std::string& name) const {
    if (!node.is_table())
      reject_case(where(node), fmt::format("{} is no table", name), fmt::format("write [{}]", name));
    return *node.as_table();
  }

  [[nodiscard]] std::string where(const toml::node& node) const { return where_is(node, file_); }

  const Declarations& tables_;
  const std::string& file_;
  Mistakes& mistakes_;
};

}  // namespace

void check_names(const toml::table& root, const Declarations& tables, const std::string& file, Mistakes& mistakes) {
  NameCheck(tables, file, mistakes).all(root);
}

}  // namespace thalweg
