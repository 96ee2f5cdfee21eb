#include "solver/program/join_ranks.hpp"

#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "common/error.hpp"
#include "common/installation.hpp"
#include "common/loaded_module.hpp"
#include "common/process.hpp"

namespace thalweg {
namespace {

/// Launchers tell the processes they start how many there are.
constexpr std::array<const char*, 3> sizes_in_environment = {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_SIZE"};

/// Several tasks that srun has started with an interface of MPI's.
bool is_step_of_slurm() {
  const char* tasks = getenv("SLURM_STEP_NUM_TASKS");
  const bool with_mpi = getenv("PMIX_RANK") != nullptr || getenv("PMI_RANK") != nullptr;
  return tasks != nullptr && std::atoi(tasks) > 1 && with_mpi;
}

bool is_one_of_several() {
  for (const char* name : sizes_in_environment) {
    const char* size = getenv(name);
    if (size != nullptr && std::atoi(size) > 1) return true;
  }
  return is_step_of_slurm();
}

namespace fs = std::filesystem;

constexpr const char* status_file = "THALWEG_STATUS_FILE";
constexpr const char* way_to_mpi =
    "install OpenMPI (Debian: apt install libopenmpi-dev openmpi-bin) and build again, or run on one rank";

}  // namespace

std::unique_ptr<Ranks> join_ranks() {
  if (!is_one_of_several()) return nullptr;
  const auto file = find_module(ranks_module);
  if (file.empty()) throw RunError(std::string("this build of Thalweg has no MPI; ") + way_to_mpi);
  // Global: OpenMPI loads components of its own, which look for its symbols.
  const LoadedModule module(file, "MPI", way_to_mpi, RTLD_GLOBAL);
  std::unique_ptr<Ranks> ranks(module.function<Ranks* (*)()>("thalweg_join_ranks")());
  return ranks->size() > 1 ? std::move(ranks) : nullptr;
}

int run_on_ranks(int ranks, const std::vector<std::string>& arguments) {
  if (find_module(ranks_module).empty()) {
    throw InputError(std::string("--ranks: this build of Thalweg has no MPI; ") + way_to_mpi);
  }
  const fs::path told = fs::temp_directory_path() / ("thalweg-status-" + std::to_string(getpid()));
  setenv(status_file, told.c_str(), 1);
  // OpenMPI's settings; other launchers do not read them. More ranks than cores wait for each other without turning in
  // circles; ranks are not tied to a core, which their threads would share; after SIGTERM there are some seconds for a
  // checkpoint, which the others get, too, when a rank was killed.
  setenv("OMPI_MCA_rmaps_base_oversubscribe", "1", 0);
  setenv("OMPI_MCA_hwloc_base_binding_policy", "none", 0);
  setenv("OMPI_MCA_odls_base_sigkill_timeout", "2", 0);
  setenv("OMPI_MCA_orte_execute_quiet", "1", 0);
  if (geteuid() == 0) {  // who runs as root, in a container, has decided so
    setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 0);
    setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 0);
  }
  std::vector<std::string> command{"mpirun", "-n", std::to_string(ranks),
                                   (program_folder() / "thalweg-solver").string()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  int status = 0;
  try {
    status = run_in_foreground(command);
  } catch (const StartError& error) {
    if (!error.not_found()) throw;
    throw InputError(std::string("--ranks: mpirun is not installed; ") + way_to_mpi);
  }
  std::ifstream file(told);
  if (int first_rank = 0; file >> first_rank) status = first_rank;
  file.close();
  std::error_code ignored;
  fs::remove(told, ignored);
  return status;
}

int tell_status(int status) {
  const char* file = getenv(status_file);
  if (file == nullptr) return status;
  std::ofstream(file) << status;
  return 0;
}

}  // namespace thalweg
