#pragma once

#include <filesystem>
#include <string>
#include <vector>

// The places of the programs' own files, found from the program that runs, so that an installed tree may be moved. They are the
// same in a build folder and where Thalweg is installed: programs in bin/, what they need in share/thalweg.
namespace thalweg {

/// Folder of the running program. Links are followed.
std::filesystem::path program_folder();

/// A file or folder below share/thalweg, whether it exists or not.
std::filesystem::path shared_file(const std::string& name);

/// The file of core module `name`, beside the program or in ../lib/thalweg of an installed tree; empty if there is none.
std::filesystem::path find_core(const std::string& name);

/// Another module of the programs' own, in the same places; empty if it is not there.
std::filesystem::path find_module(const std::string& file);

/// The module that joins the ranks of a run; builds without MPI have none.
constexpr const char* ranks_module = "thalweg_ranks_mpi.so";

/// The module that links the GPUs of ranks; builds without NCCL have none.
constexpr const char* nccl_module = "thalweg_link_nccl.so";

/// The names of all core modules that are installed, sorted: "cuda", "openmp_avx2", "openmp_avx2_double" …
std::vector<std::string> installed_cores();

}  // namespace thalweg
