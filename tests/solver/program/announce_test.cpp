#include "solver/program/announce.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace thalweg {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Case bed_of(double grain_diameter, double roughness) {
  Case c;
  c.model.sediment = SedimentModel::three_state;
  c.model.implementation = Implementation::law;
  c.numerics.spacing = 0.005;
  c.sediments["sand"].grain_diameter = grain_diameter;
  c.sediments["sand"].roughness = roughness;
  return c;
}

TEST(CoarseGrains, AreWarnedOfWhereALayerIsThinnerThanAGrain) {
  EXPECT_THAT(warnings_of_coarse_grains(bed_of(0.002, 0.005)), IsEmpty());
  EXPECT_THAT(warnings_of_coarse_grains(bed_of(0.008, 0)),
              ElementsAre(HasSubstr("materials.sand.grain_diameter = 8 mm is more than the spacing of 5 mm")));
  EXPECT_THAT(warnings_of_coarse_grains(bed_of(0.002, 0.006)),
              ElementsAre(HasSubstr("materials.sand.roughness = 6 mm is more than the spacing of 5 mm")));
}

TEST(CoarseGrains, AreNoMatterWhereNoLawMovesThem) {
  Case c = bed_of(0.008, 0.02);
  c.model.sediment = SedimentModel::viscoplastic;
  EXPECT_THAT(warnings_of_coarse_grains(c), IsEmpty());
}

}  // namespace
}  // namespace thalweg
