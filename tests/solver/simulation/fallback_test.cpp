#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <cstdlib>
#include <sstream>

#include "common/error.hpp"
#include "solver/simulation/gpu_memory.hpp"
#include "solver/simulation/input.hpp"
#include "tests/solver/lattice_scene.hpp"
#include "tests/solver/thread_ranks.hpp"

namespace thalweg {
namespace {

/// A scene of still water, and what is said while a simulation of it is made.
class Fallback : public testing::Test {
 protected:
  Fallback() : scene_(test::make_scene_of(test::LatticeSetup<2>{})) {
    particles_ = test::fill_lattice(scene_, test::all_water);
    before_ = spdlog::default_logger();
    spdlog::set_default_logger(
        std::make_shared<spdlog::logger>("test", std::make_shared<spdlog::sinks::ostream_sink_mt>(said_)));
    spdlog::set_pattern("%v");
    unsetenv("FAKE_GPU_MEMORY");
    unsetenv("FAKE_GPU_PROBLEM");
    unsetenv("FAKE_GPU_OF");
    unsetenv("FAKE_GPUS");
  }
  ~Fallback() override { spdlog::set_default_logger(before_); }

  std::unique_ptr<Simulation> make(const std::string& backend) {
    return make_simulation({.scene = scene_, .particles = &particles_, .threads = 1}, backend, "auto");
  }

  Scene<2> scene_;
  ParticleSet particles_;
  std::ostringstream said_;
  std::shared_ptr<spdlog::logger> before_;
};

TEST_F(Fallback, TakesCpuCoresWhereTheGpuIsTooSmallAndSaysSoInALine) {
  setenv("FAKE_GPU_MEMORY", "100000", 1);
  const auto simulation = make("auto");
  EXPECT_EQ(simulation->facts().device.substr(0, 6), "OpenMP");
  const std::string said = said_.str();
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1);
  EXPECT_NE(said.find("100 kB free"), std::string::npos) << said;
  EXPECT_NE(said.find("spacing of"), std::string::npos) << said;
  EXPECT_THROW(make("cuda"), InputError);
}

TEST_F(Fallback, TakesCpuCoresWhereTheGpuFailsAtTheStart) {
  EXPECT_EQ(make("auto")->facts().device.substr(0, 6), "OpenMP");
  EXPECT_NE(said_.str().find("out of memory"), std::string::npos) << said_.str();
  EXPECT_THROW(make("cuda"), RunError);
}

TEST_F(Fallback, TakesCpuCoresInSilenceWhereThereIsNoGpu) {
  setenv("FAKE_GPU_PROBLEM", "no NVIDIA GPU is visible", 1);
  EXPECT_EQ(make("auto")->facts().device.substr(0, 6), "OpenMP");
  EXPECT_EQ(said_.str(), "");
  EXPECT_THROW(make("cuda"), InputError);
}

TEST_F(Fallback, OfAllRanksGoesTheSameWay) {
  setenv("FAKE_GPU_PROBLEM", "no NVIDIA GPU is visible", 1);
  setenv("FAKE_GPU_OF", "1", 1);
  const auto make_on = [&](Ranks& ranks, const std::string& backend) {
    return make_simulation({.scene = scene_, .particles = &particles_, .threads = 1, .ranks = &ranks}, backend, "auto");
  };
  test::ThreadRanks(2).run([&](Ranks& mine) {
    EXPECT_EQ(make_on(mine, "auto")->facts().device.substr(0, 6), "OpenMP");
    try {
      make_on(mine, "cuda");
      ADD_FAILURE() << "rank 1 has no GPU";
    } catch (const InputError& e) {
      EXPECT_STREQ(e.what(), "rank 1: --backend cuda: no NVIDIA GPU is visible");
    }
  });
  EXPECT_NE(said_.str().find("the GPU of rank 1 cannot be used"), std::string::npos) << said_.str();
}

/// Errors of make_simulation on two ranks.
std::vector<std::string> refusals(const SimulationInput& input, const std::string& backend) {
  std::vector<std::string> said(2);
  test::ThreadRanks(2).run([&](Ranks& mine) {
    SimulationInput of_rank = input;
    of_rank.ranks = &mine;
    try {
      make_simulation(of_rank, backend, "auto");
    } catch (const InputError& e) {
      said[static_cast<std::size_t>(mine.rank())] = e.what();
    }
  });
  return said;
}

TEST_F(Fallback, SharesAGpusMemoryAmongTheRanksThatHaveItAndNoOthers) {
  const GpuMemory one_rank = estimate_gpu_memory(scene_, particles_, 2);
  setenv("FAKE_GPU_MEMORY", std::to_string(1.5 * one_rank.needed).c_str(), 1);
  const SimulationInput input{.scene = scene_, .particles = &particles_, .threads = 1};
  for (const std::string& said : refusals(input, "cuda")) {
    EXPECT_NE(said.find("on each rank's GPU, which has"), std::string::npos) << said;
  }
  // Each rank sees one GPU here, too, but it is another one: there is room, and the core is asked for a simulation.
  setenv("FAKE_GPUS", "2", 1);
  test::ThreadRanks(2).run([&](Ranks& mine) {
    SimulationInput of_rank = input;
    of_rank.ranks = &mine;
    EXPECT_THROW(make_simulation(of_rank, "cuda", "auto"), RunError);
  });
}

// Beside this test lies a module of NCCL's name that is none.
TEST_F(Fallback, SaysOnAllRanksWhyNcclCannotBeLoaded) {
  for (const std::string& said :
       refusals({.scene = scene_, .particles = &particles_, .threads = 1, .messages = {MessageWay::nccl}}, "auto")) {
    EXPECT_EQ(said.rfind("--device-messages nccl: rank 0: cannot load NCCL: ", 0), 0U) << said;
    EXPECT_NE(said.find("; install NVIDIA's NCCL"), std::string::npos) << said;
  }
}

TEST_F(Fallback, RefusesMessagesBetweenGpusWhereRanksHaveNone) {
  setenv("FAKE_GPU_PROBLEM", "no NVIDIA GPU is visible", 1);
  for (const auto& [way, word] : {std::pair{MessageWay::mpi, "mpi"}, std::pair{MessageWay::nccl, "nccl"}}) {
    for (const std::string& said :
         refusals({.scene = scene_, .particles = &particles_, .threads = 1, .messages = {way}}, "auto")) {
      EXPECT_EQ(said.rfind(std::string("--device-messages ") + word + ": the ranks compute on CPU cores; ", 0), 0U)
          << said;
    }
  }
}

TEST_F(Fallback, OfRanksIsSilentWhereNoneHasAGpu) {
  setenv("FAKE_GPU_PROBLEM", "no NVIDIA GPU is visible", 1);
  test::ThreadRanks(2).run([&](Ranks& mine) {
    const auto simulation =
        make_simulation({.scene = scene_, .particles = &particles_, .threads = 1, .ranks = &mine}, "auto", "auto");
    EXPECT_EQ(simulation->facts().device.substr(0, 6), "OpenMP");
  });
  EXPECT_EQ(said_.str(), "");
}

}  // namespace
}  // namespace thalweg
