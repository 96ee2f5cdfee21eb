#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <utility>

#include "common/error.hpp"
#include "common/first_problem.hpp"
#include "common/installation.hpp"
#include "common/loaded_module.hpp"
#include "solver/simulation/gpu_memory.hpp"
#include "solver/simulation/input.hpp"
#include "solver/simulation/message_way.hpp"

namespace thalweg {
namespace {

using Maker = Simulation* (*)(const SimulationInput*);
using DeviceProblem = const char* (*)();
using DeviceMemory = double (*)();
using DeviceChoice = void (*)(int);
using DeviceName = void (*)(std::uint8_t*);

struct Core {
  const char* instruction_set;
  bool (*runs_here)();
};

const std::array<Core, 3> openmp_cores = {{
#if defined(__x86_64__)
    {"avx512",
     [] {
       return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
              __builtin_cpu_supports("avx512vl") != 0 && __builtin_cpu_supports("avx512bw") != 0;
     }},
    {"avx2", [] { return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0; }},
#else
    {"avx512", [] { return false; }},
    {"avx2", [] { return false; }},
#endif
    {"baseline", [] { return true; }},
}};

/// Read when the OpenMP library is loaded, which a core does. Threads that spin while they wait for one another
/// are ten times slower on a busy machine (16.8 s against 1.4 s measured, two threads on two loaded cores); some
/// thousand turns before they sleep make Louvain with 62 500 particles a fifth faster on an idle one
/// (bench/records). The user's own settings are kept.
void let_threads_sleep() {
  if (getenv("OMP_WAIT_POLICY") == nullptr) setenv("GOMP_SPINCOUNT", "5000", 0);
  setenv("OMP_WAIT_POLICY", "passive", 0);
}

/// A core module.
class CoreModule : public LoadedModule {
 public:
  explicit CoreModule(const std::string& name)
      : LoadedModule((let_threads_sleep(), find_core(name)), "thalweg_core_" + name + ".so",
                     "build or install Thalweg again") {}

  [[nodiscard]] std::unique_ptr<Simulation> make(const SimulationInput& input) const {
    return std::unique_ptr<Simulation>(function<Maker>("thalweg_make_simulation")(&input));
  }
};

/// Of the GPU of this process, or of each rank's.
GpuMemory memory_of(const SimulationInput& input) {
  if (input.gpu_memory) return *input.gpu_memory;
  return estimate_gpu_memory(input.scene, *input.particles, input.ranks == nullptr ? 1 : input.ranks->size());
}

/// True if the pair coefficients of the viscous solve are to be stored: where there is room, or as the environment says,
/// for measurements.
bool stores_coefficients(const GpuMemory& memory, double available) {
  const char* asked = getenv("THALWEG_PAIR_COEFFICIENTS");
  const std::string word = asked == nullptr ? "" : asked;
  if (word == "stored" || word == "computed") return word == "stored";
  if (!word.empty()) throw InputError("THALWEG_PAIR_COEFFICIENTS=" + word + ": write stored or computed, or unset it");
  return coefficients_fit(memory, available);
}

/// On the GPU with the core that was loaded for it.
std::unique_ptr<Simulation> make_with(const CoreModule& core, const SimulationInput& input) {
  const double available = core.function<DeviceMemory>("thalweg_device_memory")();
  const GpuMemory memory = memory_of(input);
  require_gpu_memory(input.scene, memory, available);
  SimulationInput on_gpu = input;
  on_gpu.stores_coefficients = stores_coefficients(memory, available);
  return core.make(on_gpu);
}

constexpr const char* no_cuda_core =
    "--backend cuda: this build has no CUDA core; install the CUDA Toolkit (12 or newer), then run "
    "\"cmake --preset release\" and \"tools/build cuda\"; or use --backend openmp";

/// Refuses a device that cannot be used.
void require_device(const CoreModule& core) {
  const std::string problem = core.function<DeviceProblem>("thalweg_device_problem")();
  if (!problem.empty()) throw InputError("--backend cuda: " + problem);
}

/// A rank's GPU, before anything is made on it.
struct GpuOfRank {
  std::optional<CoreModule> core;
  bool is_found = false;  // whether it has memory enough or not
  bool has_room = false;  // for the viscous pair coefficients
  std::string problem;    // why it cannot be used
};

/// The core and the GPU of this rank, chosen among those that it sees.
void choose_gpu(GpuOfRank& gpu, int place, std::array<std::uint8_t, 16>& name) {
  if (find_core("cuda").empty()) throw InputError(no_cuda_core);
  gpu.core.emplace("cuda");
  gpu.core->function<DeviceChoice>("thalweg_choose_device")(place);
  require_device(*gpu.core);
  gpu.is_found = true;
  gpu.core->function<DeviceName>("thalweg_name_device")(name.data());
}

/// Refuses a GPU that has no room for the parts of the ranks that share it.
void require_room(GpuOfRank& gpu, const SimulationInput& input, std::ptrdiff_t sharing) {
  const double available = gpu.core->function<DeviceMemory>("thalweg_device_memory")() / static_cast<double>(sharing);
  const GpuMemory memory = memory_of(input);
  require_gpu_memory(input.scene, memory, available, input.ranks->size());
  gpu.has_room = stores_coefficients(memory, available);
}

GpuOfRank find_gpu_of_rank(const SimulationInput& input) {
  GpuOfRank gpu;
  Ranks& ranks = *input.ranks;
  std::array<std::uint8_t, 16> name{};
  gpu.problem = problem_of([&] { choose_gpu(gpu, ranks.place_on_this_machine(), name); });
  const auto names = gather_from(ranks, name);
  if (!gpu.problem.empty()) return gpu;
  gpu.problem = problem_of([&] { require_room(gpu, input, std::count(names.begin(), names.end(), name)); });
  return gpu;
}

/// On a GPU for each rank; nullptr where a rank has none to be used and nobody insists. All ranks go the same way.
std::unique_ptr<Simulation> make_on_gpus(const SimulationInput& input, bool insist) {
  Ranks& ranks = *input.ranks;
  const GpuOfRank gpu = find_gpu_of_rank(input);
  const RankProblem first = first_problem(ranks, gpu.problem);
  if (!first.text.empty()) {
    if (insist) throw InputError(fmt::format("rank {}: {}", first.rank, first.text));
    std::uint8_t any_is_found = gpu.is_found ? 1 : 0;
    ranks.largest(&any_is_found, 1);
    if (any_is_found != 0) {
      spdlog::warn("computing on CPU cores, because the GPU of rank {} cannot be used: {}", first.rank, first.text);
    }
    return nullptr;
  }
  std::uint8_t lacks_room = gpu.has_room ? 0 : 1;
  ranks.largest(&lacks_room, 1);
  SimulationInput on_gpu = input;
  on_gpu.stores_coefficients = lacks_room == 0;
  if (ranks.size() > 1 && input.messages.way == MessageWay::nccl) on_gpu.messages.links = &load_nccl(ranks);
  return gpu.core->make(on_gpu);
}

/// On the GPU; nullptr where there is none to be used and nobody insists.
std::unique_ptr<Simulation> make_on_gpu(const SimulationInput& input, bool insist) {
  if (input.ranks != nullptr) return make_on_gpus(input, insist);
  if (find_core("cuda").empty()) {
    if (!insist) return nullptr;
    throw InputError(no_cuda_core);
  }
  if (insist) {
    const CoreModule core("cuda");
    require_device(core);
    return make_with(core, input);
  }
  // Nobody insists: whatever is wrong with the GPU, CPU cores do.
  try {
    const CoreModule core("cuda");
    if (*core.function<DeviceProblem>("thalweg_device_problem")() != '\0') return nullptr;
    return make_with(core, input);
  } catch (const std::runtime_error& e) {
    spdlog::warn("computing on CPU cores, because the GPU cannot be used: {}", e.what());
    return nullptr;
  }
}

std::string name_of(const Core& core, const SimulationInput& input) {
  return fmt::format("openmp_{}{}", core.instruction_set, input.double_pair_sums ? "_double" : "");
}

/// True if the processor can run a core that is there: a build may leave some out (THALWEG_INSTRUCTION_SETS).
bool is_usable(const Core& core, const SimulationInput& input) {
  return core.runs_here() && !find_core(name_of(core, input)).empty();
}

/// The instruction set of all ranks: the best that all can use, or the one that was named. With different ones the bits
/// would depend on where a particle lies.
std::string common_instruction_set(const SimulationInput& input, const std::string& asked) {
  Ranks& ranks = *input.ranks;
  const auto mine = std::find_if(openmp_cores.begin(), openmp_cores.end(), [&](const Core& core) {
    return asked == "auto" ? is_usable(core, input) : asked == core.instruction_set;
  });
  const auto all = gather_from(ranks, mine - openmp_cores.begin());
  const auto worst = static_cast<std::size_t>(*std::max_element(all.begin(), all.end()));
  if (worst == openmp_cores.size()) return asked;  // no such instruction set, which is told below
  const std::string common = openmp_cores[worst].instruction_set;
  if (asked != "auto" && asked != common) {
    throw InputError("--isa " + asked + ": another rank computes with " + common +
                     "; give all ranks the same, or none");
  }
  return common;
}

std::unique_ptr<Simulation> make_on_cores(const SimulationInput& input, std::string instruction_set) {
  if (input.ranks != nullptr) instruction_set = common_instruction_set(input, instruction_set);
  for (const Core& core : openmp_cores) {
    const bool is_asked = instruction_set == "auto" || instruction_set == core.instruction_set;
    if (is_asked && is_usable(core, input)) return CoreModule(name_of(core, input)).make(input);
    if (instruction_set == core.instruction_set && core.runs_here()) {
      throw InputError("--isa " + instruction_set + ": thalweg_core_" + name_of(core, input) +
                       ".so is not here; leave --isa away to use the best core that is, or build it "
                       "(THALWEG_INSTRUCTION_SETS)");
    }
  }
  if (instruction_set == "auto")
    return CoreModule(name_of(openmp_cores.back(), input)).make(input);  // says what is missing
  throw InputError("--isa " + instruction_set +
                   ": this processor does not have it; leave --isa away to use the best it has, or name one of avx512, "
                   "avx2, baseline");
}

}  // namespace

std::unique_ptr<Simulation> make_simulation(const SimulationInput& input, const std::string& backend,
                                            const std::string& instruction_set) {
  if (backend != "auto" && backend != "openmp" && backend != "cuda") {
    throw InputError("--backend " + backend + ": no such device; use auto, cuda or openmp");
  }
  if (backend == "cuda" && input.double_pair_sums) {
    throw InputError(
        "--backend cuda: pair sums are single there and numerics.precision asks for double; set it to \"single\", or "
        "use --backend openmp");
  }
  // Who names an instruction set or double sums means a CPU.
  const bool may_use_gpu =
      backend == "cuda" || (backend == "auto" && instruction_set == "auto" && !input.double_pair_sums);
  auto on_gpu = may_use_gpu ? make_on_gpu(input, backend == "cuda") : nullptr;
  if (on_gpu != nullptr) return on_gpu;
  if (input.ranks != nullptr && input.ranks->size() > 1) require_no_gpus(input.messages.way);
  return make_on_cores(input, instruction_set);
}

}  // namespace thalweg
