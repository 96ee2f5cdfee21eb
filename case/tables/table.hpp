#pragma once

#include <array>
#include <limits>
#include <string>

/// The language in which the tables of a case file are declared.
///
/// A table is a struct in case/tables/, and its file holds all that there is to say about it. The list in case/case.hpp
/// names it once. The struct has
///   static constexpr TableHeading heading       its name and its sentence in the reference
///   template <class V> void describe(V& v)      its keys, each declared once; a member's initial value is the default,
///                                               `required` where there is none
/// and, as far as it needs them, the following. Each is found by its name.
///   bool uses_key(std::string_view key, int dimension) const
///       False for a key that means nothing in this entry. check_keys() refuses it, the writer leaves it out.
///   std::vector<std::string> needs_keys(int dimension) const
///       The keys without which this entry is not defined, for check_keys().
///   void set_defaults(const GivenWords& given)
///       Before the table is read: defaults that follow from words elsewhere in the file.
///   void complete(const Case& whole)
///       When all tables have been read: values that follow from other tables.
///   void check(const Case& whole, const CheckContext& at) const
///       Throws InputError where values contradict each other or another table.
///   static void check_all(const Case& whole, const CheckContext& at)
///       The same for all entries of a repeated table together, also if there are none.
///   void read_files(const std::filesystem::path& folder)
///       After the checks: takes over the content of files. Relative names are relative to `folder`.
///   std::vector<std::string> hashed_files() const
///       Names of files whose content belongs to the case's hash.
///   static T without_defaults()
///       An entry for the reference. Keys that some kinds of entry need are `required` in it.
///   static void explain_further(std::ostream& to, std::string_view key)
///       Prints what `thalweg explain` adds when it is asked for `key`.
///
/// Reader, writer, hash, `thalweg explain`, docs/case-file.md and the JSON schema are visitors of describe(). A visitor
/// offers these functions:
///   quantity(key, double&, si_unit, low, high, sentence)                   a text with a unit
///   number(key, double&, low, high, sentence)                              a plain number (dimensionless)
///   integer(key, int&, low, high, sentence)
///   flag(key, bool&, sentence)
///   text(key, std::string&, sentence)
///   texts(key, std::vector<std::string>&, sentence)
///   point(key, Vec3&, si_unit, sentence)                                   one entry per dimension, e.g. [x, z]
///   quantities(key, std::vector<double>&, si_unit, low, high, sentence)
///   polygon(key, std::vector<Vector2d>&, si_unit, sentence)                [[x, z], …]
///   choice(key, E&, sentence)                                              the words come from choices(E)
///   direction(key, Vec3&, sentence)                                        as many plain numbers; not all zero
namespace thalweg {

/// Marks a number that the case file has to give.
inline constexpr double required = std::numeric_limits<double>::quiet_NaN();

/// A table's name and meaning.
struct TableHeading {
  const char* name;            // "numerics"; "gauge" for [[gauge]]; "materials.<sediment>" for tables by name
  const char* meaning;         // one sentence
  const char* note = "";       // a paragraph for docs/case-file.md
  bool indispensable = false;  // repeated tables: a case has at least one
};

/// One admissible word of an enumerated key.
template <class E>
struct Choice {
  E value;
  const char* name;
  const char* sentence;
};

/// The word of a case file for an enumerator.
template <class E>
std::string word_for(E value) {
  for (const Choice<E>& choice : choices(E{})) {
    if (choice.value == value) return choice.name;
  }
  return {};
}

struct Case;
struct GivenWords;
class CheckContext;

}  // namespace thalweg
