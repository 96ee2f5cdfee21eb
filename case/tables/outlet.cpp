#include "case/tables/outlet.hpp"

#include <algorithm>

#include "case/case.hpp"
#include "case/models/openings.hpp"
#include "case/tables/common_checks.hpp"
#include "case/tables/time_table.hpp"
#include "common/csv.hpp"
#include "common/error.hpp"

namespace thalweg {

bool Outlet::uses_key(std::string_view key, int dimension) const {
  if (is_place(key)) return uses_place(key, dimension);
  if (key == "kind") return true;
  if (kind != OutletKind::level) return false;
  if (key == "level") return levels.empty();
  if (key == "file") return !file.empty();
  return !levels.empty();  // times, levels
}

void Outlet::check(const Case& whole, const CheckContext& at_table) const {
  check_unused_keys(at_table, *this, [&](const std::string& key) -> std::string {
    if (is_place(key)) return at_table.dimension() == 2 ? "in the plane" : "beside the other size";
    if (kind == OutletKind::level) return key == "level" ? "beside levels" : "without levels";
    return fmt::format("with kind = \"{}\"", word_for(kind));
  });
  check_place(whole, at_table);
  switch (kind) {
    case OutletKind::fall:
      return;
    case OutletKind::pump: {
      Outlet standing = *this;
      standing.level = standing.upper_edge();
      standing.levels.clear();
      standing.check_levels(whole, at_table);
      const auto is_pump = [](const Outlet& outlet) { return outlet.kind == OutletKind::pump; };
      if (whole.inlets.empty()) {
        at_table.reject(at_table.key("kind"), at_table.path() + " is a pump, and no inlet brings its water back",
                        "add an [[inlet]]");
      }
      if (std::count_if(whole.outlets.begin(), whole.outlets.end(), is_pump) > 1) {
        at_table.reject(at_table.key("kind"), at_table.path() + " is a second pump", "let one outlet be the pump");
      }
      return;
    }
    case OutletKind::level: {
      const int given = (at_table.given("level") ? 1 : 0) + (levels.empty() ? 0 : 1) + (file.empty() ? 0 : 1);
      if (given == 0) {
        at_table.reject(at_table.path(), at_table.path() + " does not say where its water stands",
                        "give level, or levels at times, or a file");
      }
      if (!levels.empty()) check_times(at_table, "levels", levels);
      if (file.empty()) check_levels(whole, at_table);
      if (!is_supercritical(*this, whole)) return;
      at_table.reject(at_table.key("level"),
                      at_table.path() + ": water at its level runs faster than waves, which cannot bring it upstream",
                      "write kind = \"fall\", or a higher level");
    }
  }
}

void Outlet::read_files(const std::filesystem::path& folder) {
  if (file.empty()) return;
  const CsvTable table = CsvTable::read(folder / file);
  times = table.numbers("time", "s");
  levels = table.numbers("level", "m");
  check_time_rows(table, times, levels);
  for (std::size_t row = 0; row < levels.size(); ++row) {
    if (levels[row] > lower_edge() && levels[row] <= upper_edge() + 1e-12) continue;
    throw InputError(table.where(row) + ": the level does not lie in the opening of outlet." + name +
                     "; correct it, or make the opening higher");
  }
  file.clear();
}

Outlet Outlet::without_defaults() {
  Outlet outlet;
  outlet.at = outlet.direction = Vec3::Constant(required);
  return outlet;
}

}  // namespace thalweg
