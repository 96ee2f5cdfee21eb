#include "tests/solver/scenes.hpp"

namespace thalweg::test {

template Loaded<2, Guarded> load(const Scene<2>&, const ParticleSet&);
template Loaded<3, Guarded> load(const Scene<3>&, const ParticleSet&);

}  // namespace thalweg::test

namespace thalweg {

template StepResult advance(test::Guarded&, Particles<test::Guarded>&, const Scene<2>&, Workspace<test::Guarded>&,
                            double, Timing&);
template std::vector<ExcludedParticle> rebuild_lists(test::Guarded&, Particles<test::Guarded>&, const Scene<2>&);
template std::vector<ExcludedParticle> rebuild_lists(test::Guarded&, Particles<test::Guarded>&, const Scene<3>&);
template class SimulationOn<2, test::Guarded>;
template class SimulationOn<3, test::Guarded>;

}  // namespace thalweg
