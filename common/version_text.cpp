#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "common/installation.hpp"
#include "common/process.hpp"
#include "common/version.hpp"

namespace thalweg {

std::string version_text(const std::string& program) {
  std::vector<std::string> cpu;
  bool cuda = false;
  constexpr std::string_view on_cpu = "openmp_";
  constexpr std::string_view twice = "_double";  // the same instruction set, with sums in double precision
  for (const std::string& core : installed_cores()) {
    cuda = cuda || core == "cuda";
    if (core.starts_with(on_cpu) && !core.ends_with(twice)) cpu.push_back(core.substr(on_cpu.size()));
  }
  std::string text = fmt::format("{} {}\n", program, version());
  text += fmt::format("commit    {}\n", build_commit());
  text += fmt::format("compiler  GCC {}, {}\n", __VERSION__, THALWEG_BUILD_TYPE);
  text += fmt::format("CPU cores {}\n", cpu.empty() ? "none installed" : fmt::format("{}", fmt::join(cpu, ", ")));
  text += fmt::format("CUDA core {}\n", cuda ? "installed" : "not installed");
  text += fmt::format("OpenFOAM  {}\n", on_path("blockMesh") ? "found" : "not found; thalweg foam needs it");
  text += fmt::format("MPI       {}\n", find_module(ranks_module).empty() ? "not in this build; --ranks needs it"
                                        : on_path("mpirun")               ? "found"
                                                                          : "no mpirun found; --ranks needs it");
  return text;
}

}  // namespace thalweg
