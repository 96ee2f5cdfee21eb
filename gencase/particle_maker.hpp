#pragma once

#include "case/case.hpp"
#include "common/particles.hpp"
#include "gencase/filling.hpp"
#include "gencase/hydrostatic.hpp"

namespace thalweg::gencase {

/// Columns [begin, end) of a lattice.
struct Columns {
  std::int64_t begin = 0;
  std::int64_t end = 0;
};

/// One particle for every node of a shape, column by column: ids follow the columns, so that neighbours in space are mostly
/// neighbours in memory. Some columns are made after the others, so that not all particles have to be in memory.
class ParticleMaker {
 public:
  /// Everything is kept by reference. `sound_speed` [m/s].
  ParticleMaker(const Case& resolved, const std::vector<PlacedShape>& shapes, const Filling& filling,
                const HydrostaticStart& start, double sound_speed);

  [[nodiscard]] bool is_done() const { return next_column_ == filling_.lattice.columns(); }
  /// The next columns, which have about so many nodes.
  [[nodiscard]] Columns next_columns(std::int64_t nodes) const;
  /// Their particles, at rest.
  ParticleSet make(const Columns& columns);

  [[nodiscard]] double largest_pressure() const { return largest_pressure_; }  // [Pa] so far

 private:
  [[nodiscard]] ParticleSet allocate(std::size_t count) const;
  [[nodiscard]] std::size_t count_in(const Columns& columns) const;

  const Case& resolved_;
  const std::vector<PlacedShape>& shapes_;
  const Filling& filling_;
  const HydrostaticStart& start_;
  double sound_speed_;
  bool has_states_;
  std::int64_t next_column_ = 0;
  std::int64_t next_id_ = 0;
  std::size_t next_wall_ = 0;
  double largest_pressure_ = 0;
};

}  // namespace thalweg::gencase
