#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "case/tables/table.hpp"
#include "common/particles.hpp"

namespace thalweg {

enum class GaugeKind { water_level, pressure, velocity, flux };

inline constexpr std::array<Choice<GaugeKind>, 4> choices(GaugeKind) {
  return {{{GaugeKind::water_level, "water level", "height of the free surface, and of the bed, over `at`"},
           {GaugeKind::pressure, "pressure", "of the fluid at `at`"},
           {GaugeKind::velocity, "velocity", "of the fluid at `at`"},
           {GaugeKind::flux, "flux",
            "volumes of water and of sediment, pores included, that cross the rectangle between `from` and `to` in a "
            "second, counted along the axis"}}};
}

/// One [[gauge]]: a measurement during the run, without snapshots.
struct Gauge {
  static constexpr TableHeading heading{
      "gauge", "What is measured during the run: one such table for every gauge (file-formats.md)."};

  std::string name;
  GaugeKind kind = GaugeKind::water_level;
  Vec3 at = Vec3::Zero();    // [m]
  Vec3 from = Vec3::Zero();  // [m]
  Vec3 to = Vec3::Zero();    // [m]

  template <class V>
  void describe(V& v) {
    v.text("name", name, "Name of the gauge, unique in the case; heads its columns in gauges.csv.");
    v.choice("kind", kind, "What it measures.");
    v.point("at", at, "m", "water level, pressure, velocity: where; of a water level the height means nothing.");
    v.point("from", from, "m", "flux: one corner of a rectangle across an axis.");
    v.point("to", to, "m", "flux: the opposite corner, equal to `from` along that axis.");
  }

  [[nodiscard]] bool uses_key(std::string_view key, int dimension) const;
  [[nodiscard]] std::vector<std::string> needs_keys(int dimension) const;
  void check(const Case& whole, const CheckContext& context) const;
  static Gauge without_defaults();
};

}  // namespace thalweg
