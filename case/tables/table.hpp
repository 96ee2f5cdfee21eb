#pragma once

#include <array>
#include <limits>
#include <string>

/// The language in which the tables of a case file are declared.
///
/// A table is a struct in case/tables/. Its file holds all there is to say about it; case/case.hpp lists it once. The struct has
///   static constexpr TableHeading heading          its name, and its sentence in the reference
///   template <class V> void describe(V& v)         its keys, each declared once; a member's initial value is the default
///                                                  (`required` where there is none)
/// and of the following what it needs:
///   bool uses_key(std::string_view key, int dimension) const       false for a key that means nothing in this entry: it is
///                                                                  refused (check_keys) and not written
///   std::vector<std::string> needs_keys(int dimension) const       the keys without which this entry is not defined
///   void set_defaults(const GivenWords& given)                     before it is read: defaults that follow from words
///   void complete(const Case& whole)                               once all tables are read: values that follow from others
///   void check(const Case& whole, const CheckContext& at) const    throws InputError where values contradict each other
///   static void check_all(const Case& whole, const CheckContext&)  the same for all entries together, even if there are none
///   void read_files(const std::filesystem::path& folder)           takes over what stands in files
///   std::vector<std::string> hashed_files() const                  files whose content belongs to the case's hash
///   static T without_defaults()                                    an entry for the reference in which keys are `required` that
///                                                                  some kinds of entry need
///   static void explain_further(std::ostream& to, std::string_view key)  what `thalweg explain` adds to its keys
///
/// Reader, writer, hash, `thalweg explain`, docs/case-file.md and the JSON schema are visitors of describe(). A visitor offers:
///   quantity(key, double&, si_unit, low, high, sentence)                 a text with a unit
///   number(key, double&, low, high, sentence)                            a plain number (dimensionless)
///   integer(key, int&, low, high, sentence)
///   flag(key, bool&, sentence)
///   text(key, std::string&, sentence)
///   texts(key, std::vector<std::string>&, sentence)
///   point(key, Vec3&, si_unit, sentence)                                 one entry per dimension: [x, z] or [x, y, z]
///   quantities(key, std::vector<double>&, si_unit, low, high, sentence)
///   polygon(key, std::vector<Vector2d>&, si_unit, sentence)              [[x, z], …]
///   choice(key, E&, sentence)                                            the words come from choices(E)
///   direction(key, Vec3&, sentence)                                      plain numbers, one per dimension; any length but zero
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
