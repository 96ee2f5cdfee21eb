#include "case/tables/line.hpp"

#include "case/tables/common_checks.hpp"

namespace thalweg {
namespace {

void check_place(const CheckContext& at, const char* key, const std::vector<double>& place) {
  if (place.size() == 2) return;
  at.reject(at.key(key), fmt::format("{} has {} entries", at.key(key), place.size()), "give two, x and y");
}

}  // namespace

void ProfileLine::check(const Case&, const CheckContext& at) const {
  check_file_name(at, name);
  if (name == "all") {
    at.reject(at.key("name"), at.key("name") + " is taken by the profiles of all snapshots", "rename it");
  }
  if (at.dimension() == 2) {
    at.reject(at.path(), "a case with dimension = 2 has one profile, along x", "remove [[line]]");
  }
  check_place(at, "from", from);
  check_place(at, "to", to);
  if (from == to) {
    at.reject(at.key("to"), fmt::format("{} equals {}", at.key("to"), at.key("from")), "give the line some length");
  }
}

}  // namespace thalweg
