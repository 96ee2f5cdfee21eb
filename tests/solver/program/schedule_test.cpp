#include "solver/program/schedule.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace thalweg {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;

TEST(Schedule, JoinsIntervalTimesAndComparison) {
  Case c;
  c.output.end = 0.5;
  c.output.interval = 0.2;
  c.output.times = {0.25, 0.4000000001};  // the second is a multiple of the interval, written differently
  c.compare.times = {0.25, 0.5, 0.75};    // the last lies beyond the end
  EXPECT_THAT(snapshot_times(c), ElementsAre(DoubleEq(0), DoubleEq(0.2), DoubleEq(0.25), DoubleEq(0.4), DoubleEq(0.5)));
}

TEST(Schedule, WithoutAnIntervalIsStartAndEnd) {
  Case c;
  c.output.end = 2;
  EXPECT_THAT(snapshot_times(c), ElementsAre(0, 2));
}

}  // namespace
}  // namespace thalweg
