#include "tests/solver/scenes.hpp"

namespace thalweg::test {

template Loaded<2, Cpu> load(const Scene<2>&, const ParticleSet&);
template Loaded<3, Cpu> load(const Scene<3>&, const ParticleSet&);

}  // namespace thalweg::test

namespace thalweg {

template StepResult advance(test::Cpu&, Particles<test::Cpu>&, const Scene<2>&, Workspace<test::Cpu>&, double, Timing&);
template std::vector<ExcludedParticle> rebuild_lists(test::Cpu&, Particles<test::Cpu>&, const Scene<2>&);
template std::vector<ExcludedParticle> rebuild_lists(test::Cpu&, Particles<test::Cpu>&, const Scene<3>&);
template class SimulationOn<2, test::Cpu>;
template class SimulationOn<3, test::Cpu>;

}  // namespace thalweg
