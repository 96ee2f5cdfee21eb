#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "common/error.hpp"
#include "common/one_rank.hpp"
#include "common/particle_slices.hpp"
#include "solver/simulation/start.hpp"
#include "tests/solver/case_run.hpp"
#include "tests/solver/thread_ranks.hpp"

// Runs of a scene on several ranks, and what has to be the same on any number of them.
namespace thalweg::test {

struct Scenario {
  const char* name;
  const char* scene;
  std::vector<std::string> overrides;
  int steps;
};
inline void PrintTo(const Scenario& s, std::ostream* to) { *to << s.name; }

struct Outcome {
  ParticleSet first;  // before any step
  ParticleSet last;
  Totals totals;
  SimulationFacts facts;
};

inline Outcome outcome_of(Simulation& simulation, const ParticleFileInfo& start, int steps) {
  Outcome outcome;
  outcome.first = simulation.snapshot();
  double time = start.time;
  for (int n = 0; n < steps; ++n) {
    simulation.set_time(time);
    time += simulation.advance(1).dt;
  }
  outcome.last = simulation.full_state();
  outcome.last.info = start;
  outcome.last.info.time = time;
  outcome.last.info.step += steps;
  outcome.totals = simulation.totals();
  outcome.facts = simulation.facts();
  return outcome;
}

/// On one device of the backend by itself.
inline Outcome run_alone(const std::string& backend, const Case& of, const ParticleSet& start, int steps) {
  return outcome_of(*start_simulation(of, start, {backend, "auto", 1}), start.info, steps);
}

/// A set that is read range by range.
class SetSource final : public ParticleSource {
 public:
  explicit SetSource(const ParticleSet& of) : of_(of) {
    frame_.info = of.info;
    frame_.facts = of.facts;
  }
  [[nodiscard]] std::uint64_t size() const override { return of_.size(); }
  [[nodiscard]] const ParticleSet& frame() const override { return frame_; }
  ParticleSet range(std::uint64_t from, std::uint64_t to) override {
    if (to > unreadable_from) throw InputError("p.vtp: cannot be read");
    largest = std::max(largest, to - from);
    return slice(of_, from, to);
  }

  std::uint64_t largest = 0;  // range that was read
  std::uint64_t unreadable_from = ~std::uint64_t{0};

 private:
  const ParticleSet& of_;
  ParticleSet frame_;
};

inline Outcome run_on(int ranks, const std::string& backend, const Case& of, const ParticleSet& start, int steps,
                      const std::string& device_messages = "auto") {
  if (ranks == 1) {
    OneRank mine;
    StartOptions options{backend, "auto", 1};
    options.ranks = &mine;
    return outcome_of(*lead(start_simulation(of, start, options), mine), start.info, steps);
  }
  Outcome outcome;
  ThreadRanks(ranks).run([&](Ranks& mine) {
    StartOptions shared{backend, "auto", 1};
    shared.ranks = &mine;
    shared.device_messages = device_messages;
    const ParticleSet nothing;  // the first rank alone reads the file
    SetSource source(start);
    const bool is_first = mine.rank() == 0;
    std::unique_ptr<Simulation> share =
        deals_in_ranges(of, shared)
            ? start_simulation(of, is_first ? StartSource{&source, "p.vtp"} : StartSource{}, shared)
            : start_simulation(of, is_first ? start : nothing, shared);
    if (mine.rank() == 0) {
      outcome = outcome_of(*lead(std::move(share), mine), start.info, steps);
    } else {
      follow(*share, mine);
    }
  });
  return outcome;
}

/// Number of unequal entries.
template <class T>
std::size_t unequal(const std::vector<T>& a, const std::vector<T>& b) {
  if (a.size() != b.size()) return std::max(a.size(), b.size());
  std::size_t n = 0;
  for (std::size_t i = 0; i < a.size(); ++i) n += a[i] == b[i] ? 0 : 1;
  return n;
}

inline void expect_same(const ParticleSet& a, const ParticleSet& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(unequal(a.id, b.id), 0U);
  EXPECT_EQ(unequal(a.position, b.position), 0U);
  EXPECT_EQ(unequal(a.velocity, b.velocity), 0U);
  EXPECT_EQ(unequal(a.pressure, b.pressure), 0U);
  EXPECT_EQ(unequal(a.density, b.density), 0U);
  ASSERT_EQ(a.scalars.size(), b.scalars.size());
  for (const auto& [name, array] : a.scalars) EXPECT_EQ(unequal(array, b.scalars.at(name)), 0U) << name;
  ASSERT_EQ(a.doubles.size(), b.doubles.size());
  for (const auto& [name, array] : a.doubles) EXPECT_EQ(unequal(array, b.doubles.at(name)), 0U) << name;
  EXPECT_EQ(a.facts, b.facts);
}

inline void expect_same(const Outcome& one, const Outcome& several) {
  expect_same(one.first, several.first);
  expect_same(one.last, several.last);
  EXPECT_EQ(one.totals.kinetic_energy, several.totals.kinetic_energy);
  EXPECT_EQ(one.totals.potential_energy, several.totals.potential_energy);
  EXPECT_EQ(one.totals.momentum[0], several.totals.momentum[0]);
  EXPECT_EQ(one.totals.grain_mass, several.totals.grain_mass);
  EXPECT_EQ(one.facts.particles, several.facts.particles);
}

}  // namespace thalweg::test
