#include "solver/simulation/message_way.hpp"

#include <fmt/format.h>

#include "common/error.hpp"
#include "common/first_problem.hpp"
#include "common/installation.hpp"
#include "common/loaded_module.hpp"

namespace thalweg {

MessageWay message_way(const std::string& word) {
  if (word == "auto") return MessageWay::automatic;
  if (word == "host") return MessageWay::host;
  if (word == "mpi") return MessageWay::mpi;
  if (word == "nccl") return MessageWay::nccl;
  throw InputError("--device-messages " + word + ": no such way; use auto, host, mpi or nccl");
}

void require_no_gpus(MessageWay way) {
  if (way != MessageWay::mpi && way != MessageWay::nccl) return;
  throw InputError(
      fmt::format("--device-messages {}: the ranks compute on CPU cores; leave it away, or give every rank a GPU "
                  "(--backend cuda says why it has none)",
                  way == MessageWay::mpi ? "mpi" : "nccl"));
}

LinkMaker& load_nccl(Ranks& ranks) {
  LinkMaker* links = nullptr;
  const auto load = [&] {
    const auto file = find_module(nccl_module);
    if (file.empty()) {
      throw RunError(
          "this build of Thalweg has no NCCL; install NVIDIA's NCCL with its headers (libnccl-dev) beside the CUDA "
          "Toolkit and build again");
    }
    const LoadedModule module(file, "NCCL", "install NVIDIA's NCCL (libnccl2), or name its folder in LD_LIBRARY_PATH");
    links = module.function<LinkMaker* (*)()>("thalweg_nccl_links")();
  };
  const RankProblem first = first_problem(ranks, problem_of(load));
  if (first.text.empty()) return *links;
  throw InputError(
      fmt::format("--device-messages nccl: rank {}: {}, or leave --device-messages away", first.rank, first.text));
}

}  // namespace thalweg
