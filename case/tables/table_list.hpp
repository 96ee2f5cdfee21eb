#pragma once

#include <fmt/format.h>

#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

#include "case/tables/table.hpp"

// Loops over the tables of a case. C is a struct like Case: its static constexpr tables() returns the pointers to its
// members that are tables, in the order in which they are read, written and described. The type of a member says how
// often its table may occur.
namespace thalweg {

enum class TableForm {
  single,    // T: [numerics]
  repeated,  // std::vector<T>: [[gauge]], each with a name in its key `name`
  by_name    // std::map<std::string, T>: [materials.pvc], the name being part of the table's
};

/// Entry: the struct of one table; form: how often it may occur.
template <class Member>
struct TableTraits {
  using Entry = Member;
  static constexpr TableForm form = TableForm::single;
};
template <class T>
struct TableTraits<std::vector<T>> {
  using Entry = T;
  static constexpr TableForm form = TableForm::repeated;
};
template <class T>
struct TableTraits<std::map<std::string, T>> {
  using Entry = T;
  static constexpr TableForm form = TableForm::by_name;
};

/// The part of a name before its first dot: "materials" of "materials.<sediment>" and of "materials.water"; empty
/// without.
inline std::string_view group_of(std::string_view name) {
  const auto dot = name.find('.');
  return dot == std::string_view::npos ? std::string_view() : name.substr(0, dot);
}

/// Calls visit(member) for the member of each table.
template <class C, class Visit>
void for_each_table(C& of, Visit&& visit) {
  std::apply([&](auto... member) { (visit(of.*member), ...); }, C::tables());
}

/// One table of a case.
struct EntryPlace {
  TableForm form;
  const TableHeading& heading;
  std::string name;  // of a repeated table or one by name, else empty

  /// "numerics", "gauge.weir", "materials.pvc": its name in messages and overrides.
  [[nodiscard]] std::string path() const {
    switch (form) {
      case TableForm::single:
        return heading.name;
      case TableForm::repeated:
        return fmt::format("{}.{}", heading.name, name);
      case TableForm::by_name:
        return fmt::format("{}.{}", group_of(heading.name), name);
    }
    return {};
  }
};

/// Calls visit(place, entry) for each table in a member of a case: the single one, each repeated one, each one by name.
template <class Member, class Visit>
void for_each_entry_of(Member& member, Visit&& visit) {
  using Traits = TableTraits<std::remove_const_t<Member>>;
  const TableHeading& heading = Traits::Entry::heading;
  if constexpr (Traits::form == TableForm::single) {
    visit(EntryPlace{Traits::form, heading, {}}, member);
  } else if constexpr (Traits::form == TableForm::repeated) {
    for (auto& entry : member) visit(EntryPlace{Traits::form, heading, entry.name}, entry);
  } else {
    for (auto& [name, entry] : member) visit(EntryPlace{Traits::form, heading, name}, entry);
  }
}

/// The same for every table of a case.
template <class C, class Visit>
void for_each_entry(C& of, Visit&& visit) {
  for_each_table(of, [&](auto& member) { for_each_entry_of(member, visit); });
}

}  // namespace thalweg
