#include <gtest/gtest.h>

#include <string>

#include "common/error.hpp"
#include "common/one_rank.hpp"
#include "solver/simulation/message_way.hpp"

// The module of NCCL where it is built. Messages need several GPUs; tools/gpu-check sends them.
namespace thalweg {
namespace {

TEST(NcclModule, IsLoadedAndNamesTheGpuOrTheCallThatFails) {
  OneRank alone;
  LinkMaker& links = load_nccl(alone);
  try {
    const LinkPart part = links.part(true);
    EXPECT_NE(part.device, LinkPart().device);
    EXPECT_NE(part.meeting, LinkPart().meeting);
    EXPECT_EQ(links.part(false).device, part.device);
    EXPECT_EQ(links.part(false).meeting, LinkPart().meeting) << "the ranks meet where the first one says";
  } catch (const RunError& e) {
    EXPECT_EQ(std::string(e.what()).rfind("cudaGetDevice", 0), 0U) << e.what();
  }
}

}  // namespace
}  // namespace thalweg
