#include "physics/sediment/dilatancy.hpp"

#include <gtest/gtest.h>

namespace thalweg {
namespace {

// Boyer et al. 2011 at I_v = 1e-2: 0.585/1.1 = 0.5318
TEST(Dilatancy, TheSteadyPackingOpensWithTheRateOfShear) {
  EXPECT_NEAR(steady_solids(0.585, 1e-3, 100.0, 10.0), 0.53182, 1e-5);
  EXPECT_EQ(steady_solids(0.585, 1e-3, 0.0, 10.0), 0.585);
  EXPECT_EQ(steady_solids(0.585, 1e-3, 0.0, 0.0), 0.585 / 2);  // without any pressure
  EXPECT_EQ(steady_solids(0.585, 1e-3, 1e9, 10.0), 0.585 / 2);
}

// 4.09 * 0.02 = 0.0818
TEST(Dilatancy, OpensADensePackingAndClosesALooseOne) {
  EXPECT_NEAR(dilatancy(4.09, 0.60, 0.58), 0.0818, 1e-12);
  EXPECT_NEAR(dilatancy(4.09, 0.56, 0.58), -0.0818, 1e-12);
  EXPECT_EQ(dilatancy(4.09, 0.58, 0.58), 0);
  EXPECT_EQ(dilatancy(40.0, 0.70, 0.58), 0.5);
  EXPECT_EQ(dilatancy(40.0, 0.40, 0.58), -0.5);
}

}  // namespace
}  // namespace thalweg
