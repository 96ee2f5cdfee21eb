#include "solver/program/schedule.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/program/progress.hpp"

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

TEST(BedSchedule, PassesEachTimeOnceAndKnowsItsEnd) {
  Case of;
  of.compare.bed_times = {30, 10};
  of.surface_bed.end = 40;
  BedSchedule schedule(of);
  schedule.begin(0);
  EXPECT_FALSE(schedule.passes(9));
  EXPECT_TRUE(schedule.passes(10));
  EXPECT_FALSE(schedule.passes(29));
  EXPECT_TRUE(schedule.passes(35));
  EXPECT_FALSE(schedule.is_at_end(35));
  EXPECT_TRUE(schedule.passes(45));
  EXPECT_TRUE(schedule.is_at_end(45));
}

TEST(BedSchedule, GoesOnBehindWhatWasDueBefore) {
  Case of;
  of.compare.bed_times = {10, 30};
  BedSchedule schedule(of);
  schedule.begin(20);
  EXPECT_FALSE(schedule.passes(21));
  EXPECT_TRUE(schedule.passes(30));
  EXPECT_FALSE(schedule.is_at_end(1e9));
}

TEST(Progress, CountsTowardsTheNearerEnd) {
  EXPECT_DOUBLE_EQ(share_done({1, 0}, {4, 0}), 0.25);
  EXPECT_DOUBLE_EQ(share_done({1, 30}, {4, 60}), 0.5);
  EXPECT_DOUBLE_EQ(share_done({3, 30}, {4, 60}), 0.75);
  EXPECT_DOUBLE_EQ(share_done({1, 30}, {4, 0}), 0.25);  // a bed whose time ends nothing
}

}  // namespace
}  // namespace thalweg
