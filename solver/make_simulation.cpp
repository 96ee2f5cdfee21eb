#include <dlfcn.h>

#include <array>
#include <cstdlib>
#include <filesystem>

#include "common/error.hpp"
#include "solver/simulation.hpp"

namespace thalweg {
namespace {

using Maker = Simulation* (*)(const SimulationInput*);

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

/// The core modules lie beside the program, or in ../lib/thalweg of an installed tree.
Maker load(const std::string& name) {
  // Read when the OpenMP library is loaded, which the core does. Threads that spin while they wait for one another are
  // a tenth faster on an idle machine and ten times slower on a busy one (16.8 s against 1.4 s measured, two threads on
  // two loaded cores); the user's own setting is kept.
  setenv("OMP_WAIT_POLICY", "passive", 0);
  const auto program = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  const std::string file = "thalweg_core_" + name + ".so";
  std::string problem = "not found beside the program";
  for (const auto& folder : {program, program.parent_path() / "lib" / "thalweg", program.parent_path() / "bin"}) {
    if (!std::filesystem::exists(folder / file)) continue;
    if (void* module = dlopen((folder / file).c_str(), RTLD_NOW | RTLD_LOCAL)) {
      // Data pointer to function pointer: the conversion dlsym is made for.
      return reinterpret_cast<Maker>(dlsym(module, "thalweg_make_simulation"));
    }
    problem = dlerror();
  }
  throw RunError("cannot load " + file + ": " + problem + "; build or install Thalweg again");
}

}  // namespace

std::unique_ptr<Simulation> make_simulation(const SimulationInput& input, const std::string& backend,
                                            const std::string& instruction_set) {
  if (backend != "auto" && backend != "openmp") {
    throw InputError("--backend " + backend + ": this build has no such device; use --backend openmp");
  }
  for (const Core& core : openmp_cores) {
    if (instruction_set != "auto" && instruction_set != core.instruction_set) continue;
    if (!core.runs_here()) continue;
    return std::unique_ptr<Simulation>(load(std::string("openmp_") + core.instruction_set)(&input));
  }
  throw InputError("--isa " + instruction_set +
                   ": this processor does not have it; leave --isa away to use the best it has, or name one of avx512, "
                   "avx2, baseline");
}

}  // namespace thalweg
