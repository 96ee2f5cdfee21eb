// Micro-benchmarks of the solver's passes and sweeps; compiled once per instruction set, as the cores are.
// bench/micro/micro.py runs them and writes the table.
#include <benchmark/benchmark.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/micro/peak.hpp"
#include "solver/backend/openmp.hpp"
#include "solver/simulation/simulation_on.hpp"
#include "tests/solver/lattice_scene.hpp"

namespace thalweg {
namespace {

using Device = OpenMp<>;

/// A periodic box, walls at its bottom, sediment up to the middle and water over it, every particle a fifth of a
/// spacing or less off its node and moving. h = 1.5 dp: 113 neighbours in space, 28 in the plane.
template <int Dim>
struct Bed {
  Device on;
  Particles<Device> p;
  Scene<Dim> scene;
  ViscousSystem<Device> viscous;
  StepState state;

  explicit Bed(int edge) {
    on.threads = 1;
    test::LatticeSetup<Dim> setup;
    setup.length = edge * setup.spacing;
    setup.periodic = true;
    setup.gravity.vertical() = -9.81F;
    scene = test::make_scene_of(setup);
    scene.has_sediment = scene.has_states = true;
    const double dp = scene.spacing;
    ParticleSet start = test::fill_lattice(
        scene,
        [&](const Vec3& x) {
          if (x.z() < 4 * dp) return ParticleType::wall;
          return x.z() < 0.5 * setup.length ? ParticleType::sediment : ParticleType::water;
        },
        0.2);
    std::mt19937 random(11);
    std::uniform_real_distribution<float> any(-1, 1);
    for (std::size_t i = 0; i < start.size(); ++i) {
      start.velocity[i] = Eigen::Vector3f(any(random), Dim == 3 ? any(random) : 0, any(random));
      start.pressure[i] = 1000 + 100 * any(random);
      start.density[i] *= 1 + 1e-3F * any(random);
    }
    start.viscosity.assign(start.size(), 10);
    load_particles(on, p, scene, start);
    rebuild_lists(on, p, scene);
    state.step.dt = 1e-4;
    viscous.row.resize(p.count);
    viscous.coefficient.resize(p.list_entries.size() * cluster_size);
    viscous.vectors.resize(p.count + 1);
    for (Vectors& v : viscous.vectors) v = {};
  }

  static Bed& of(int edge) {
    static int made_for = 0;
    static std::unique_ptr<Bed> bed;  // one at a time: the largest take some hundred megabytes
    if (made_for != edge) bed = std::make_unique<Bed>(edge), made_for = edge;
    return *bed;
  }

  template <class Body>
  void sweep(ClusterRange range, const Body& body) {
    on.template sweep<Dim>(p.list(), range, p.record.data(), scene.metric(), body);
  }
  template <class Body, class T, class Add>
  void sweep_and_sum(ClusterRange range, const Body& body, const T& zero, const Add& add) {
    sweep_and_sum(range, p.record.data(), body, zero, add);
  }
  template <class From, class Body, class T, class Add>
  void sweep_and_sum(ClusterRange range, const From* from, const Body& body, const T& zero, const Add& add) {
    T sum = zero;
    on.template sweep_then<Dim>(p.list(), range, from, scene.metric(), body, zero, add,
                                [&](const T& found) { sum = found; });
    benchmark::DoNotOptimize(sum);
  }
};

/// The pairs that a sweep over some clusters visits.
struct Meetings {
  double particles = 0;
  double useful = 0;   // pairs of two particles within the kernel's support
  double entries = 0;  // of the lists, padding included
};

template <int Dim>
Meetings meetings(const Bed<Dim>& bed, ClusterRange range) {
  Meetings m;
  const ClusterList list = bed.p.list();
  const Record* records = bed.p.record.data();
  const double support2 = 4 * bed.scene.smoothing_length * bed.scene.smoothing_length;
  const Index stride = range.count > 4096 ? 17 : 1;
  for (Index n = 0; n < range.count; n += stride) {
    const Index c = range[n];
    m.entries += list.begin[c + 1] - list.begin[c];
    for (Index i = list.first(c); i < list.last(c); ++i) {
      m.particles += 1;
      for (Index e = list.begin[c]; e < list.begin[c + 1]; ++e) {
        const Index j = list.entries[e];
        if (j == i || j == list.count) continue;
        double r2 = 0;
        for (int k = 0; k < Dim; ++k) {
          const double d = bed.scene.distance(k, records[i].place[axis<Dim>(k)], records[j].place[axis<Dim>(k)]);
          r2 += d * d;
        }
        if (r2 < support2) m.useful += 1;
      }
    }
  }
  const double share = double(range.count) / std::ceil(double(range.count) / stride);
  return {share * m.particles, share * m.useful, share * m.entries};
}

using Counter = benchmark::Counter;

void count_particles(benchmark::State& state, double particles) {
  state.counters["particles"] = particles;
  state.counters["s/particle"] = Counter(particles, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

/// Bytes that have to come from memory and go there: for a particle beside its record and list, and for a lane.
struct Traffic {
  double particle = 0;
  double lane = 0;
};

template <int Dim>
void register_sweep(const std::string& name, int edge, const std::function<ClusterRange(Bed<Dim>&)>& range_of,
                    const std::function<void(Bed<Dim>&, ClusterRange)>& sweep, Traffic traffic) {
  const auto run = [=](benchmark::State& state) {
    Bed<Dim>& bed = Bed<Dim>::of(edge);
    const ClusterRange range = range_of(bed);
    const Meetings m = meetings(bed, range);
    for (auto _ : state) {
      sweep(bed, range);
      benchmark::ClobberMemory();
    }
    count_particles(state, m.particles);
    state.counters["neighbours"] = m.useful / m.particles;
    state.counters["lanes/particle"] = m.entries * cluster_size / m.particles;
    state.counters["pairs/s"] = Counter(m.useful, Counter::kIsIterationInvariantRate);
    state.counters["bytes/particle"] =
        sizeof(Record) + traffic.particle + m.entries * (sizeof(Index) + cluster_size * traffic.lane) / m.particles;
  };
  benchmark::RegisterBenchmark((std::to_string(Dim) + "-D/" + name + "/" + std::to_string(edge)).c_str(), run);
}

template <int Dim>
void register_pass(const std::string& name, int edge, const std::function<void(Bed<Dim>&)>& pass, double bytes) {
  const auto run = [=](benchmark::State& state) {
    Bed<Dim>& bed = Bed<Dim>::of(edge);
    for (auto _ : state) {
      pass(bed);
      benchmark::ClobberMemory();
    }
    count_particles(state, bed.p.count);
    state.counters["bytes/particle"] = bytes;
  };
  benchmark::RegisterBenchmark((std::to_string(Dim) + "-D/" + name + "/" + std::to_string(edge)).c_str(), run);
}

template <int Dim>
void register_all(int edge) {
  using B = Bed<Dim>;
  using Row = typename ViscousSystem<Device>::Row;
  using Kept = typename Device::PairCoefficient;
  using Coupling = ViscousCoupling<Dim>;
  const auto fluid = [](B& b) { return b.p.all_fluid(); };
  // A line that is written comes from memory and goes back.
  const double rates = 2 * sizeof(Rates), row = 2 * sizeof(Row);

  register_sweep<Dim>("density rate", edge, fluid,
                      [](B& b, ClusterRange r) {
                        b.sweep(r, ContinuitySweep<Dim>{b.p.record.data(), b.p.rates.data(), b.scene});
                      },
                      {.particle = rates});
  register_sweep<Dim>("density rate and strain", edge, fluid,
                      [](B& b, ClusterRange r) {
                        const ContinuitySweep<Dim> water{b.p.record.data(), b.p.rates.data(), b.scene};
                        b.sweep(r, ContinuityAndStrainSweep<Dim, false>{water, b.p.sediment.data(), nullptr});
                      },
                      {.particle = rates + 2 * sizeof(Sediment)});
  register_sweep<Dim>("momentum", edge, fluid,
                      [](B& b, ClusterRange r) {
                        b.sweep(r, MomentumSweep<Dim>{b.p.record.data(), b.p.rates.data(), b.scene});
                      },
                      {.particle = rates});
  register_sweep<Dim>(
      "viscous coefficients", edge, fluid,
      [](B& b, ClusterRange r) {
        const ViscousCoefficientSweep<Dim, true, Kept, Row, Coupling> body{b.p.record.data(),
                                                                           b.p.mass.data(),
                                                                           b.p.rates.data(),
                                                                           b.p.sediment.data(),
                                                                           iteration_vector<true>(b.p, b.viscous),
                                                                           b.viscous.coefficient.data(),
                                                                           b.viscous.row.data(),
                                                                           {b.scene},
                                                                           &b.state};
        b.sweep_and_sum(r, body, viscosity::Norms{}, viscosity::AddNorms{});
      },
      {.particle = row + sizeof(Rates) + sizeof(Sediment) + sizeof(float) + sizeof(Vectors), .lane = 2 * sizeof(Kept)});
  register_sweep<Dim>("viscous product", edge, fluid,
                      [](B& b, ClusterRange r) {
                        const auto vector = iteration_vector<true>(b.p, b.viscous);
                        const ViscousProductSweep<Dim, true, Kept, Row, Coupling> body{
                            b.p.record.data(),    vector,    b.viscous.coefficient.data(),
                            b.viscous.row.data(), {b.scene}, &b.state};
                        b.sweep_and_sum(r, vector.from, body, 0.0, std::plus<>());
                      },
                      {.particle = row + sizeof(Vectors), .lane = sizeof(Kept)});
  register_sweep<Dim>("viscous product, nothing stored", edge, fluid,
                      [](B& b, ClusterRange r) {
                        const ViscousProductSweep<Dim, false, Kept, Row, Coupling> body{
                            b.p.record.data(), iteration_vector<false>(b.p, b.viscous),
                            nullptr,           b.viscous.row.data(),
                            {b.scene},         &b.state};
                        b.sweep_and_sum(r, body, 0.0, std::plus<>());
                      },
                      {.particle = row});
  register_sweep<Dim>(
      "bed surface", edge, [](B& b) { return b.p.at_bed_surface(); },
      [](B& b, ClusterRange r) {
        b.sweep(r, BedSurfaceSweep<Dim>{b.p.record.data(), b.p.bed.data(), b.scene});
      },
      {.particle = 2 * sizeof(BedSurface)});
  register_sweep<Dim>(
      "wall pressure", edge, [](B& b) { return b.p.walls_near_fluid(); },
      [](B& b, ClusterRange r) {
        b.sweep(r, WallPressureSweep<Dim>{{b.scene}, b.p.record.data()});
      },
      {.particle = sizeof(Record)});

  register_pass<Dim>(
      "equation of state", edge, [](B& b) { apply_equation_of_state(b.on, b.p, b.scene); },
      2 * sizeof(Record) + sizeof(float));
  register_pass<Dim>(
      "kick", edge, [](B& b) { kick(b.on, b.p, &b.state); }, 2 * sizeof(Record) + sizeof(Rates));
  register_pass<Dim>(
      "drift", edge, [](B& b) { drift(b.on, b.p, b.scene, &b.state, 0); }, 2 * sizeof(Record) + 2 * sizeof(Position));
  register_pass<Dim>(
      "viscous update", edge,
      [](B& b) {
        reduce_members_then(b.on, b.p.list(), b.p.all_fluid(), viscosity::Norms{},
                            ViscousUpdatePass<Row, IterationVector<true>>{iteration_vector<true>(b.p, b.viscous),
                                                                          b.viscous.row.data(), &b.state},
                            viscosity::AddNorms{}, [](const viscosity::Norms& n) { benchmark::DoNotOptimize(n); });
      },
      2 * sizeof(Vectors) + row);
  register_pass<Dim>(
      "largest drift", edge, [](B& b) { neighbours::find_squared_drift(b.on, b.p, b.scene, &b.state); },
      sizeof(Record) + sizeof(Place));
  register_pass<Dim>(
      "sort", edge, [](B& b) { neighbours::sort_particles(b.on, b.p, b.scene); }, 0);
  register_pass<Dim>(
      "lists", edge, [](B& b) { neighbours::build_lists(b.on, b.p, b.scene); }, 0);
}

}  // namespace
}  // namespace thalweg

int main(int argc, char** argv) {
  benchmark::RegisterBenchmark("peak/multiply-add", thalweg::peak::multiply_add);
  benchmark::RegisterBenchmark("peak/read", thalweg::peak::read_memory)
      ->Arg(1 << 15)
      ->Arg(1 << 19)
      ->Arg(1 << 23)
      ->Arg(1 << 28);
  // 1.7, 33 and 373 thousand particles: records and lists fit the second and third level of a cache of today, and none.
  for (const int edge : {12, 32, 72}) thalweg::register_all<3>(edge);
  for (const int edge : {42, 181, 611}) thalweg::register_all<2>(edge);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
}
