// A module in place of NCCL's, which links the stand-ins for GPUs of ranks that are threads.
#include "tests/solver/thread_link.hpp"

extern "C" __attribute__((visibility("default"))) thalweg::LinkMaker* thalweg_nccl_links() {
  static thalweg::test::ThreadLinks links;
  return &links;
}
