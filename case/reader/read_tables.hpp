#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "case/check_context.hpp"
#include "case/reader/declare.hpp"
#include "case/reader/lenient_reader.hpp"
#include "case/reader/mistakes.hpp"
#include "case/reader/names.hpp"
#include "case/reader/table_reader.hpp"
#include "case/tables/given_words.hpp"
#include "case/tables/table_list.hpp"

namespace thalweg {

/// All texts and whole numbers of the single tables of a case file.
GivenWords given_words(const toml::table& root, const std::filesystem::path& folder, const CaseOrigins& origins);

/// Fills the tables of C, a struct like Case (case/tables/table_list.hpp) that also offers `int dimension() const`,
/// valid as soon as the tables before the first point have been read.
template <class C>
class TablesReader {
 public:
  TablesReader(const toml::table& root, const Declarations& tables, const GivenWords& given, CaseOrigins& origins,
               Mistakes& mistakes, C& into)
      : root_(root), tables_(tables), given_(given), origins_(origins), mistakes_(mistakes), into_(into) {}

  void read() {
    for_each_table(into_, [&](auto& member) { read_member(member); });
  }

  void complete() {
    for_each_entry(into_, [&]<class T>(const EntryPlace&, T& table) {
      if constexpr (requires { &T::complete; }) table.complete(into_);
    });
  }

  void check() const {
    bool goes_on = true;
    for_each_table(into_, [&]<class Member>(const Member& member) {
      using T = typename TableTraits<Member>::Entry;
      if (!goes_on) return;
      if (!check_entries(member)) {
        goes_on =
            std::string_view(T::heading.name) != "domain";  // against which shapes, openings and gauges are checked
        return;
      }
      if constexpr (requires { &T::check_all; }) {
        mistakes_.attempt([&] { T::check_all(into_, context(T::heading.name, T::heading.name)); });
      }
    });
  }

  void read_files() {
    for_each_entry(into_, [&]<class T>(const EntryPlace&, T& table) {
      if constexpr (requires { &T::read_files; }) {
        mistakes_.attempt([&] { table.read_files(given_.folder); });
      }
    });
  }

 private:
  template <class T>
  void read_entry(T& table, const toml::table* from, const std::string& path) {
    if constexpr (requires { &T::set_defaults; }) table.set_defaults(given_);
    LenientReader reader(TableReader(from, path, into_.dimension(), origins_), mistakes_);
    table.describe(reader);
  }

  // A single table, which may be absent.
  template <class T>
  void read_member(T& table) {
    read_entry(table, root_.at_path(T::heading.name).as_table(), T::heading.name);
  }

  // A repeated table.
  template <class T>
  void read_member(std::vector<T>& entries) {
    const toml::array* nodes = root_[T::heading.name].as_array();
    if (nodes == nullptr) return;
    for (const toml::node& node : *nodes) {
      const toml::table* table = node.as_table();
      T& entry = entries.emplace_back();
      read_entry(entry, table, fmt::format("{}.{}", T::heading.name, name_of_entry(*table)));
      if constexpr (requires { entry.line; }) entry.line = static_cast<int>(node.source().begin.line);
    }
  }

  // Tables by name: all of their group but those that are single tables.
  template <class T>
  void read_member(std::map<std::string, T>& entries) {
    const toml::table* group = root_[group_of(T::heading.name)].as_table();
    if (group == nullptr) return;
    for (const auto& [key, node] : *group) {
      const std::string name(key.str());
      const std::string path = fmt::format("{}.{}", group_of(T::heading.name), name);
      if (find_table(tables_, path)->form != TableForm::by_name) continue;
      read_entry(entries[name], node.as_table(), path);
    }
  }

  // False if one of them is wrong: what its table has to say of all entries together would follow from that.
  template <class Member>
  bool check_entries(const Member& member) const {
    using T = typename TableTraits<Member>::Entry;
    bool right = true;
    if constexpr (requires { &T::check; }) {
      for_each_entry_of(member, [&](const EntryPlace& place, const T& table) {
        right = mistakes_.attempt([&] { table.check(into_, context(place.path(), T::heading.name)); }) && right;
      });
    }
    return right;
  }

  [[nodiscard]] CheckContext context(std::string path, const char* table) const {
    return {origins_, std::move(path), find_table(tables_, table)->key_names(), into_.dimension()};
  }

  const toml::table& root_;
  const Declarations& tables_;
  const GivenWords& given_;
  CaseOrigins& origins_;
  Mistakes& mistakes_;
  C& into_;
};

/// Fills the tables of `into` from `root` and checks them: names first, then every value for itself, then what
/// contradicts each other. `folder` is the one of the case; the places of keys go to `origins`, whose `file` and
/// `resolved` the caller sets. Throws InputError with all mistakes of names and values, or else all contradictions, each as "where:
/// what is wrong; what to do".
template <class C>
void read_tables(const toml::table& root, const Declarations& tables, const std::filesystem::path& folder,
                 CaseOrigins& origins, C& into) {
  Mistakes mistakes;
  if (!mistakes.attempt([&] { check_names(root, tables, origins.file, mistakes); })) mistakes.throw_any();
  const GivenWords given = given_words(root, folder, origins);
  TablesReader<C> reader(root, tables, given, origins, mistakes, into);
  reader.read();
  mistakes.throw_any();
  reader.complete();
  reader.check();
  mistakes.throw_any();
  reader.read_files();
  mistakes.throw_any();
}

}  // namespace thalweg
