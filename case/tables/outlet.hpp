#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "case/tables/opening.hpp"

namespace thalweg {

/// The words of outlet.kind.
enum class OutletKind { fall, level, pump };

inline constexpr std::array<Choice<OutletKind>, 3> choices(OutletKind) {
  return {{{OutletKind::fall, "fall", "what crosses the plane is gone, and nothing holds it back"},
           {OutletKind::level, "level", "water beyond the plane stands at `level`: the tail water of a channel"},
           {OutletKind::pump, "pump",
            "as much water leaves as the inlets bring, whatever its level: what leaves enters again"}}};
}

/// One [[outlet]]: an opening through which water and sediment leave.
struct Outlet : Opening {
  static constexpr TableHeading heading{
      "outlet", "Where water and sediment leave the scene: one such table for every opening (openings.md).",
      "Behind the plane of an outlet the scene goes on for a zone as long as the neighbour lists reach and two "
      "spacings, with its floor. Particles are taken out at its end."};

  OutletKind kind = OutletKind::fall;

  template <class V>
  void describe(V& v) {
    describe_place(v, "Name of the outlet, unique among inlets and outlets; heads its columns in history.csv.");
    v.choice("kind", kind, "What the water meets there.");
    v.quantity("level", level, "m", -1e6, 1e6, "kind = \"level\": height z of the water's surface.");
    v.quantities("times", times, "s", 0, 1e9, "kind = \"level\": times of a table, increasing.");
    v.quantities("levels", levels, "m", -1e6, 1e6, "kind = \"level\": the level at `times`.");
    v.text("file", file, "kind = \"level\": the table as CSV, relative to the case's folder: time [s] and level [m].");
  }

  [[nodiscard]] bool uses_key(std::string_view key, int dimension) const;
  void check(const Case& whole, const CheckContext& at_table) const;
  /// The rows of the file become times and levels, so that the resolved case holds them.
  void read_files(const std::filesystem::path& folder);
  static Outlet without_defaults();
};

}  // namespace thalweg
