#pragma once

#include "gencase/filling.hpp"
#include "gencase/particle_maker.hpp"

namespace thalweg::gencase {

/// Gives the water of a driven flow the velocity that flow.start names, column by column: the depth is that of the water
/// in one piece around a node, the roughness that of the wall or sediment below it. `particles` are those of these columns
/// of the filling, in the order of its nodes. Nothing happens where it starts at rest.
void start_flow(const Case& scene, const std::vector<PlacedShape>& shapes, const Filling& filling,
                const Columns& columns, ParticleSet& particles);

/// The seam of the period of a driven flow: without water there nothing could flow around it.
class Seam {
 public:
  explicit Seam(const Case& scene) : scene_(scene) {}
  /// Looks for water among some of the particles.
  void look(const ParticleSet& particles);
  /// Throws InputError if water lies at one end of the period alone, or at none.
  void require_water() const;

 private:
  const Case& scene_;
  bool low_ = false;
  bool high_ = false;
};

}  // namespace thalweg::gencase
