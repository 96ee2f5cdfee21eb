#pragma once

#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

#include "case/case.hpp"
#include "common/particles.hpp"

namespace thalweg {

/// The water of a filled scene, whose current is driven. The particles come range by range, in the order of the file, so that
/// the sums have the same bits however long the ranges are.
class WaterBody {
 public:
  explicit WaterBody(const Case& of)
      : spacing_(of.numerics.spacing),
        column_(std::pow(of.numerics.spacing, of.info.dimension - 1)),
        component_(of.flow.component()) {}

  void add(const ParticleSet& range) {
    for (std::size_t i = 0; i < range.size(); ++i) {
      if (range.type[i] != ParticleType::water) continue;
      mass_ += double(range.mass[i]);
      if (!range.velocity.empty()) momentum_ += double(range.mass[i]) * double(range.velocity[i][component_]);
      columns_.emplace(std::llround(std::floor(range.position[i].x() / spacing_)),
                       std::llround(std::floor(range.position[i].y() / spacing_)));
    }
  }

  [[nodiscard]] double mass() const { return mass_; }          // [kg]
  [[nodiscard]] double momentum() const { return momentum_; }  // along the flow [kg m/s]
  /// Area of the columns of the lattice that hold water [m^(dim-1)].
  [[nodiscard]] double plan() const { return static_cast<double>(columns_.size()) * column_; }

 private:
  double spacing_;  // [m]
  double column_;   // [m^(dim-1)]
  int component_;
  double mass_ = 0;
  double momentum_ = 0;
  std::set<std::pair<std::int64_t, std::int64_t>> columns_;
};

}  // namespace thalweg
