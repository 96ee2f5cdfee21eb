#include "common/extraction/classified_particles.hpp"

#include "common/error.hpp"

namespace thalweg {
namespace {

const ParticleSet& with_lengths(const ParticleSet& set) {
  if (!(set.info.spacing > 0) || !(set.info.smoothing_length > 0)) {
    throw InputError("the particle file does not say its spacing and smoothing length; write it with thalweg-solver");
  }
  return set;
}

}  // namespace

ClassifiedParticles::ClassifiedParticles(const ParticleSet& set, double rest_speed)
    : particles(with_lengths(set)),
      parts(parts_of(set, rest_speed)),
      walls(find_wall_runs(set, set.info.spacing)),
      has_sediment(holds_sediment(set)),
      rest_is_known(knows_rest(set)) {}

}  // namespace thalweg
