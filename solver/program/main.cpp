#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "common/command_line.hpp"
#include "common/console.hpp"
#include "common/error.hpp"
#include "common/io/run_results.hpp"
#include "common/one_rank.hpp"
#include "common/signals.hpp"
#include "solver/program/join_ranks.hpp"
#include "solver/program/run.hpp"
#include "solver/program/warning_sink.hpp"

namespace {

bool leads = false;  // this is the first of several ranks

/// The arguments of this program without --ranks.
std::vector<std::string> without_ranks(int argc, char** argv) {
  std::vector<std::string> kept;
  for (int n = 1; n < argc; ++n) {
    const std::string_view word = argv[n];
    if (word == "--ranks") {
      ++n;
    } else if (!word.starts_with("--ranks=")) {
      kept.emplace_back(word);
    }
  }
  return kept;
}

int solver(int argc, char** argv) {
  CLI::App app("Runs the two-phase SPH solver on a folder that thalweg-gencase has filled.", "thalweg-solver");
  thalweg::RunOptions options;
  app.add_option("DIR", options.folder, "Run folder with particles.vtp and case.resolved.toml")->required();
  app.add_option("--backend", options.backend, "Device: auto takes a GPU if there is one")
      ->type_name("auto|cuda|openmp")
      ->capture_default_str();
  app.add_option("--isa", options.instruction_set, "Instruction set of the CPU core")
      ->type_name("auto|avx512|avx2|baseline")
      ->capture_default_str();
  app.add_option("--threads", options.threads, "CPU threads; 0: all cores")
      ->check(CLI::Range(0, 4096))
      ->capture_default_str();
  int ranks = 0;
  app.add_option(
         "--ranks", ranks,
         "Compute on so many processes, which mpirun starts; each has its share of the particles (docs/ranks.md)")
      ->check(CLI::Range(1, 65536))
      ->type_name("N");
  app.add_option("--device-messages", options.device_messages,
                 "Messages between the GPUs of ranks: auto takes mpi where that works, else host (docs/ranks.md)")
      ->type_name("auto|host|mpi|nccl")
      ->capture_default_str();
  app.add_option("--restart", options.restart,
                 "Continue from this checkpoint; latest: from the run's last whole one, or its start if it has none");
  app.add_option("--restart-anyway", options.restart_anyway,
                 "Keys that may differ from those of the checkpoint's case, e.g. numerics.cfl (docs/file-formats.md)")
      ->type_name("KEY...");
  app.add_flag("--force", options.force,
               "Start from particles.vtp although the folder holds results, and replace them");
  app.add_option("--until", options.until, "Stop at this physical time instead of output.end, e.g. \"0.5 s\"");
  app.add_flag("--profile", options.profile,
               "Wait for the GPU after every heading of timing.csv, so that each has its own time; slower");
  app.add_option("--benchmark", options.benchmark,
                 "Take so many steps and write nothing but summary.csv and timing.csv")
      ->check(CLI::PositiveNumber);
  app.add_flag("--deterministic")->description("For scripts: results never depend on the number of threads anyway");
  app.add_option("--set", options.overrides,
                 "Change a key of the case, e.g. numerics.cfl=0.2 (numerics, model, output)");
  if (const auto status = thalweg::parse_command_line(app, argc, argv)) return *status;
  auto shared = thalweg::join_ranks();
  if (shared == nullptr && ranks > 1) return thalweg::run_on_ranks(ranks, without_ranks(argc, argv));
  if (shared == nullptr && ranks == 1 && options.backend == "cuda") shared = std::make_unique<thalweg::OneRank>();
  leads = shared != nullptr && shared->rank() == 0;
  options.ranks = shared.get();
  thalweg::start_console();
  const auto status = static_cast<int>(thalweg::run_solver(options));
  if (shared == nullptr || shared->rank() == 0) thalweg::set_result(thalweg::summary_json({options.folder}));
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  thalweg::catch_signals();
  const int status = thalweg::run_program(solver, argc, argv);
  return leads ? thalweg::tell_status(status) : status;
}
