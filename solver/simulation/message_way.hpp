#pragma once

#include <string>

#include "solver/backend/device_link.hpp"

namespace thalweg {

/// The way that --device-messages names: "auto", "host", "mpi" or "nccl". Throws InputError for any other word.
MessageWay message_way(const std::string& word);

/// Throws InputError for a way from the memory of GPUs, where ranks compute on CPU cores.
void require_no_gpus(MessageWay way);

/// The module that links GPUs by NCCL, loaded to the end of the process on all ranks. Throws InputError on all ranks if one
/// of them cannot load it.
LinkMaker& load_nccl(Ranks& ranks);

}  // namespace thalweg
