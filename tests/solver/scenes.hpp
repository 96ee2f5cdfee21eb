#pragma once

#include <gtest/gtest.h>

#include <string>
#include <type_traits>
#include <utility>

#include "solver/backend/openmp.hpp"
#include "solver/simulation/simulation_on.hpp"
#include "tests/solver/guarded_runtime.hpp"
#include "tests/solver/lattice_scene.hpp"

// Scenes on a device, for tests that call passes by themselves. Tests of passes run on both backends (TYPED_TEST_SUITE
// with Backends): on one of them the host cannot reach the device's memory, so that tests look() at copies of the
// particles and change() them as a whole.
namespace thalweg::test {

using Cpu = OpenMp<4>;
using Guarded = Gpu<GuardedRuntime>;
using Backends = testing::Types<Cpu, Guarded>;

/// Names of the backends in the names of tests.
struct BackendNames {
  template <class On>
  static std::string GetName(int) {
    return std::is_same_v<On, Cpu> ? "OpenMp" : "GuardedGpu";
  }
};

/// Particles on the device, lists built; what a pass needs to be called by itself.
template <int Dim, class On = Cpu>
struct Loaded {
  On on;
  Particles<On> p;
  Scene<Dim> scene;
};

template <class On, int Dim>
Loaded<Dim, On> load(const Scene<Dim>& scene, const ParticleSet& from) {
  Loaded<Dim, On> l{On{}, {}, scene};
  load_particles(l.on, l.p, scene, from);
  rebuild_lists(l.on, l.p, scene);
  return l;
}

/// A copy of an array of a device.
template <class On, class Buffer>
auto copy_of(const On& on, const Buffer& buffer) {
  using T = std::remove_cvref_t<decltype(on.download(buffer)[0])>;
  if (buffer.empty()) return HostBuffer<T>{};
  const auto entries = on.download(buffer);
  return HostBuffer<T>(entries.begin(), entries.end());
}

/// Copies of the particles' arrays on the host; empty where the scene does not have them.
struct Seen {
  Index count = 0;
  Index fluid_count = 0;
  HostBuffer<Record> record;
  HostBuffer<Position> position;
  HostBuffer<float> mass;
  HostBuffer<std::int64_t> id;
  HostBuffer<Rates> rates;
  HostBuffer<Sediment> sediment;
  HostBuffer<BedSurface> bed;
  HostBuffer<PoreState> pores;
  HostBuffer<float> excess_pore_pressure;
  HostBuffer<double> grains;
  HostBuffer<Suspended> suspended;

  /// Calls visit(copy, the device's array) for every array.
  template <class P, class Visit>
  void each(P& p, const Visit& visit) {
    visit(record, p.record);
    visit(position, p.position);
    visit(mass, p.mass);
    visit(id, p.id);
    visit(rates, p.rates);
    visit(sediment, p.sediment);
    visit(bed, p.bed);
    visit(pores, p.pores);
    visit(excess_pore_pressure, p.excess_pore_pressure);
    visit(grains, p.grains);
    visit(suspended, p.suspended);
  }
};

/// The particles as they are now.
template <int Dim, class On>
Seen look(const Loaded<Dim, On>& l) {
  Seen seen;
  seen.count = l.p.count;
  seen.fluid_count = l.p.fluid_count;
  seen.each(l.p, [&](auto& copy, const auto& array) { copy = copy_of(l.on, array); });
  return seen;
}

/// Changes the particles from the host: what(Seen&).
template <int Dim, class On, class What>
void change(Loaded<Dim, On>& l, const What& what) {
  Seen seen = look(l);
  what(seen);
  seen.each(l.p, [&](auto& copy, auto& array) {
    if (!copy.empty()) l.on.upload(std::move(copy), array);
  });
}

/// A step whose stages and passes a test calls by itself.
template <int Dim, class On>
struct TestStep {
  Workspace<On> work;
  Timing timing;
  Step<Dim, On> step;

  TestStep(Loaded<Dim, On>& l, double dt) : step{l.on, l.p, l.scene, work, timing} { begin(dt); }

  /// Begins a step of dt seconds.
  void begin(double dt) {
    work.state.resize(1);
    step.state = work.state.data();
    step.now = {};
    step.now.step.dt = dt;
    step.on.write(step.now, step.state);
  }
  [[nodiscard]] StepState* state() { return step.state; }
  [[nodiscard]] StepState read() const { return step.on.read(step.state); }
};

// Compiled once, in scenes_on_cpu.cpp and scenes_on_guarded_gpu.cpp.
extern template Loaded<2, Cpu> load(const Scene<2>&, const ParticleSet&);
extern template Loaded<3, Cpu> load(const Scene<3>&, const ParticleSet&);
extern template Loaded<2, Guarded> load(const Scene<2>&, const ParticleSet&);
extern template Loaded<3, Guarded> load(const Scene<3>&, const ParticleSet&);

}  // namespace thalweg::test

namespace thalweg {

extern template StepResult advance(test::Cpu&, Particles<test::Cpu>&, const Scene<2>&, Workspace<test::Cpu>&, double,
                                   Timing&);
extern template StepResult advance(test::Guarded&, Particles<test::Guarded>&, const Scene<2>&,
                                   Workspace<test::Guarded>&, double, Timing&);
extern template std::vector<ExcludedParticle> rebuild_lists(test::Cpu&, Particles<test::Cpu>&, const Scene<2>&);
extern template std::vector<ExcludedParticle> rebuild_lists(test::Guarded&, Particles<test::Guarded>&, const Scene<2>&);
extern template std::vector<ExcludedParticle> rebuild_lists(test::Cpu&, Particles<test::Cpu>&, const Scene<3>&);
extern template std::vector<ExcludedParticle> rebuild_lists(test::Guarded&, Particles<test::Guarded>&, const Scene<3>&);
extern template class SimulationOn<2, test::Cpu>;
extern template class SimulationOn<3, test::Cpu>;
extern template class SimulationOn<2, test::Guarded>;
extern template class SimulationOn<3, test::Guarded>;

}  // namespace thalweg
