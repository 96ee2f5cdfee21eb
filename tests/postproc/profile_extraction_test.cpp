#include "common/extraction/profile_extraction.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/error.hpp"
#include "tests/postproc/manufactured.hpp"

namespace thalweg {
namespace {

using manufactured::flat;
using manufactured::Flume;

struct Misfit {
  double rms = 0;
  double largest = 0;
};

// Misfit of a curve against the height it was made from, over the columns between `from` and `to`.
Misfit misfit(const std::vector<double>& x, const std::vector<double>& z, const Flume::Height& truth, double from,
              double to) {
  double sum = 0;
  double largest = 0;
  int count = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] < from || x[i] > to) continue;
    const double error = std::isnan(z[i]) ? 1e9 : z[i] - truth(x[i]);  // a hole in the curve is a misfit too
    sum += error * error;
    largest = std::max(largest, std::abs(error));
    ++count;
  }
  EXPECT_GT(count, 10);
  return {std::sqrt(sum / count), largest};
}

double at(const Profile& profile, const std::vector<double>& z, double x) {
  const auto found = std::min_element(profile.x.begin(), profile.x.end(),
                                      [&](double a, double b) { return std::abs(a - x) < std::abs(b - x); });
  return z[static_cast<std::size_t>(found - profile.x.begin())];
}

// Half of the reach of the kernel on either side of the crossing sees a full lattice, so the crossing of a flat
// surface is exact up to the lattice's ripple; a jittered lattice (20 % of dp) adds the noise of about 28 neighbours.
TEST(ExtractProfile, FlatSurfacesAreExactToATenthOfTheSpacingUpToTheSideWalls) {
  for (const double jitter : {0.0, 0.2}) {
    for (const double offset : {0.0, 0.0013, 0.0025}) {
      Flume flume;
      flume.jitter = jitter;
      flume.begin();
      flume.add_walls();
      const auto bed = [&](double) { return 0.06 + offset; };
      const auto surface = [&](double) { return 0.16 + offset; };
      flume.fill(ParticleType::sediment, 0, 1, flat, bed);
      flume.fill(ParticleType::water, 0, 1, bed, surface);
      for (Vec3& at : flume.set.position) at = at.cast<float>().cast<double>();  // as in a snapshot
      const ExtractedProfile found = extract_profile(flume.set, {});
      const double rms_limit = 0.1 * flume.spacing;
      const double peak_limit = (jitter > 0 ? 0.3 : 0.1) * flume.spacing;
      const Profile& profile = found.profile;
      ASSERT_NEAR(profile.x.front(), 0, 1e-9);
      ASSERT_NEAR(profile.x.back(), 1, 1e-9);
      const auto expect_at = [&](const std::vector<double>& curve, const Flume::Height& truth) {
        const Misfit error = misfit(profile.x, curve, truth, 0, 1);
        EXPECT_LT(error.rms, rms_limit) << "jitter " << jitter << " offset " << offset;
        EXPECT_LT(error.largest, peak_limit) << "jitter " << jitter << " offset " << offset;
      };
      expect_at(profile.free_surface, surface);
      expect_at(profile.bed, bed);
      expect_at(profile.moving_bed, bed);
      for (const double floor : found.profile.floor) EXPECT_NEAR(floor, 0, 0.1 * flume.spacing);
    }
  }
}

TEST(ExtractProfile, TiltedPlaneIsExactToATenthOfTheSpacing) {
  for (const double jitter : {0.0, 0.2}) {
    Flume flume;
    flume.jitter = jitter;
    flume.begin();
    flume.add_walls();
    const auto surface = [](double x) { return 0.05 + 0.2 * x; };
    flume.fill(ParticleType::water, 0, 1, flat, surface);
    const Profile profile = extract_profile(flume.set, {}).profile;
    const Misfit inside = misfit(profile.x, profile.free_surface, surface, 0.02, 0.98);
    EXPECT_LT(inside.rms, 0.1 * flume.spacing);
    EXPECT_TRUE(profile.bed.empty());
    EXPECT_TRUE(profile.moving_bed.empty());
  }
}

TEST(ExtractProfile, SineBedUnderWaterKeepsItsShape) {
  for (const double jitter : {0.0, 0.2}) {
    Flume flume;
    flume.jitter = jitter;
    flume.begin();
    flume.add_walls();
    const auto bed = [](double x) { return 0.06 + 0.02 * std::sin(2 * std::numbers::pi * x / 0.2); };
    const auto surface = [](double) { return 0.16; };
    flume.fill(ParticleType::sediment, 0, 1, flat, bed);
    flume.fill(ParticleType::water, 0, 1, bed, surface);
    const Profile profile = extract_profile(flume.set, {}).profile;
    const Misfit error = misfit(profile.x, profile.bed, bed, 0, 1);
    EXPECT_LT(error.rms, 0.25 * flume.spacing);
    EXPECT_LT(error.largest, flume.spacing);
  }
}

// A bed that is a surface keeps spare rows as wall particles, all at one place of the floor. They are no more floor than one.
TEST(ExtractProfile, SpareRowsOfABedDoNotRaiseABareFloor) {
  Flume flume;
  flume.begin();
  flume.add_walls();
  for (double x = flume.spacing / 2; x < 1; x += flume.spacing) {
    for (int row = 0; row < 5; ++row) flume.add(ParticleType::wall, {x, 0, -flume.spacing / 2});
  }
  const auto bed = [](double x) { return x < 0.5 ? 0 : 0.02; };
  flume.fill(ParticleType::sediment, 0.5, 1, flat, bed);
  flume.fill(ParticleType::water, 0, 1, bed, [](double) { return 0.1; });
  const Profile profile = extract_profile(flume.set, {}).profile;
  for (const double x : {0.1, 0.2, 0.4}) {
    EXPECT_NEAR(at(profile, profile.bed, x), 0, 0.1 * flume.spacing);
    EXPECT_NEAR(at(profile, profile.floor, x), 0, 0.1 * flume.spacing);
  }
  EXPECT_NEAR(at(profile, profile.bed, 0.8), 0.02, 0.1 * flume.spacing);
}

// A film thinner than the kernel's support over a floor, over a bed, and the same with the floor out of reach below.
TEST(ExtractProfile, ThinFilmsKeepTheirThickness) {
  for (const int layers : {1, 2, 3}) {
    Flume flume;
    flume.begin();
    flume.add_walls();
    const double thickness = layers * flume.spacing;
    const auto bed = [](double x) { return x < 0.5 ? 0 : 0.05; };
    flume.fill(ParticleType::sediment, 0.5, 1, flat, bed);
    flume.fill(ParticleType::water, 0, 1, bed, [&](double x) { return bed(x) + thickness; });
    const Profile profile = extract_profile(flume.set, {}).profile;
    for (const double x : {0.0, 0.1, 0.3}) {
      EXPECT_NEAR(at(profile, profile.free_surface, x), thickness, 0.1 * flume.spacing) << layers << " layers at " << x;
      EXPECT_NEAR(at(profile, profile.bed, x), 0, 0.1 * flume.spacing);  // scoured bare: the floor
    }
    for (const double x : {0.6, 0.8, 1.0}) {
      const double water = at(profile, profile.free_surface, x) - at(profile, profile.bed, x);
      EXPECT_NEAR(water, thickness, 0.1 * flume.spacing) << layers << " layers at " << x;
    }
  }
}

TEST(ExtractProfile, FloatingGrainsAndDropsMoveNothing) {
  Flume flume;
  flume.begin();
  flume.add_walls();
  const auto bed = [](double) { return 0.06; };
  const auto surface = [](double) { return 0.16; };
  flume.fill(ParticleType::sediment, 0, 1, flat, bed);
  flume.fill(ParticleType::water, 0, 1, bed, surface);
  const Profile still = extract_profile(flume.set, {}).profile;

  flume.add(ParticleType::sediment, {0.3025, 0, 0.11});  // a grain in the water
  flume.add(ParticleType::water, {0.5025, 0, 0.18});     // spray
  const auto drop_from = [](double) { return 0.25; };
  const auto drop_to = [](double) { return 0.30; };
  flume.fill(ParticleType::water, 0.7, 0.75, drop_from, drop_to);  // a drop of 10 by 10 particles, more than half full
  flume.fill(ParticleType::sediment, 0.8, 0.85, drop_from, drop_to);  // a lump of sediment thrown into the air
  const Profile stirred = extract_profile(flume.set, {}).profile;
  EXPECT_THAT(stirred.bed, testing::Pointwise(testing::DoubleNear(1e-12), still.bed));
  EXPECT_THAT(stirred.free_surface, testing::Pointwise(testing::DoubleNear(0.02 * flume.spacing), still.free_surface));
}

TEST(ExtractProfile, AnOverhangingWaveShowsItsCrestAndDoesNotBreakTheProfile) {
  Flume flume;
  flume.begin();
  flume.add_walls();
  const auto bed = [](double) { return 0.04; };
  const auto calm = [](double) { return 0.08; };
  const auto crest = [](double) { return 0.16; };
  flume.fill(ParticleType::sediment, 0, 1, flat, bed);
  flume.fill(ParticleType::water, 0, 1, bed, calm);
  flume.fill(ParticleType::water, 0.3, 0.36, calm, crest);  // the wave's back
  flume.fill(
      ParticleType::water, 0.36, 0.5, [](double) { return 0.12; }, crest);  // its lip, over air
  const Profile profile = extract_profile(flume.set, {}).profile;
  const double tolerance = 0.1 * flume.spacing;
  EXPECT_NEAR(at(profile, profile.free_surface, 0.33), 0.16, tolerance);
  EXPECT_NEAR(at(profile, profile.free_surface, 0.44), 0.16, tolerance);
  EXPECT_NEAR(at(profile, profile.free_surface, 0.55), 0.08, tolerance);
  for (std::size_t i = 0; i < profile.x.size(); ++i) {
    EXPECT_FALSE(std::isnan(profile.free_surface[i])) << profile.x[i];
    EXPECT_NEAR(profile.bed[i], 0.04, tolerance) << profile.x[i];
  }
}

TEST(ExtractProfile, DryBedIsTheFreeSurfaceAndEmptyColumnsAreMissing) {
  Flume flume;
  flume.begin();
  flume.add_walls();
  const auto bed = [](double) { return 0.06; };
  flume.fill(ParticleType::sediment, 0, 0.7, flat, bed);
  flume.fill(ParticleType::water, 0, 0.4, bed, [](double) { return 0.12; });
  const ExtractedProfile found = extract_profile(flume.set, {});
  const Profile& profile = found.profile;
  for (std::size_t i = 0; i < profile.x.size(); ++i) {
    const double x = profile.x[i];
    if (x > 0.42 && x < 0.68) {
      EXPECT_DOUBLE_EQ(profile.free_surface[i], profile.bed[i]);
      EXPECT_NEAR(profile.bed[i], 0.06, 0.1 * flume.spacing);
    } else if (x > 0.72) {
      EXPECT_TRUE(std::isnan(profile.free_surface[i]) && std::isnan(profile.bed[i]) &&
                  std::isnan(profile.moving_bed[i]))
          << x;
    }
  }
  EXPECT_NEAR(found.front, 0.4, flume.spacing);
  EXPECT_NEAR(profile.x.back(), 1, 1e-9);  // the grid does not depend on where the fluid is
}

/// Adds wall in x from left to right and z from low to high [m].
void add_block(Flume& flume, double left, double right, double low, double high) {
  for (double x = left + 0.5 * flume.spacing; x < right; x += flume.spacing) {
    for (double z = low + 0.5 * flume.spacing; z < high; z += flume.spacing) flume.add(ParticleType::wall, {x, 0, z});
  }
}

// A thick floor is a shell of four layers along each of its faces. Where nothing lies on it, its upper side is the floor,
// also where the domain cuts it, so that it is open at its ends.
TEST(ExtractProfile, ADryFloorThatIsHollowHasItsUpperSide) {
  for (const bool has_ends : {true, false}) {
    SCOPED_TRACE(has_ends);
    Flume flume;
    flume.begin();
    flume.add_walls();
    const double side = 4 * flume.spacing;
    add_block(flume, -side, 1 + side, -0.15, -0.13);
    if (has_ends) add_block(flume, -side, 0, -0.13, -side);
    if (has_ends) add_block(flume, 1, 1 + side, -0.13, -side);
    flume.fill(ParticleType::sediment, 0.2, 0.6, flat, [](double) { return 0.06; });
    flume.fill(
        ParticleType::water, 0.2, 0.6, [](double) { return 0.06; }, [](double) { return 0.1; });
    const Profile profile = extract_profile(flume.set, {}).profile;
    EXPECT_NEAR(at(profile, profile.floor, 0.1), 0, 1e-9);
    EXPECT_NEAR(at(profile, profile.floor, 0.9), 0, 1e-9);
    EXPECT_NEAR(at(profile, profile.floor, 0.4), 0, 0.1 * flume.spacing);
  }
}

// Under a bridge that nothing flows through yet the ground counts, and in a closed box its floor, not its lid.
TEST(ExtractProfile, AnOpenGapBetweenWallsIsNoHollow) {
  Flume bridge;
  bridge.begin();
  bridge.add_walls();
  add_block(bridge, 0.6, 0.8, 0.1, 0.12);
  bridge.fill(ParticleType::water, 0, 0.3, flat, [](double) { return 0.06; });
  const Profile under = extract_profile(bridge.set, {}).profile;
  EXPECT_NEAR(at(under, under.floor, 0.7), 0, 1e-9);

  Flume box;
  box.begin();
  box.add_walls();
  add_block(box, 0, 1, 0.38, 0.4);
  box.fill(ParticleType::water, 0, 0.3, flat, [](double) { return 0.06; });
  const Profile in = extract_profile(box.set, {}).profile;
  EXPECT_NEAR(at(in, in.floor, 0.7), 0, 1e-9);
}

// A pipe that hangs over a bed hides nothing of it; one that lies in the bed does.
TEST(ExtractProfile, ShowsTheBedBelowAPipe) {
  for (const double pipe_bottom : {0.10, 0.06}) {
    SCOPED_TRACE(pipe_bottom);
    Flume flume;
    flume.begin();
    flume.add_walls();
    const auto height = [](double z) { return [z](double) { return z; }; };
    flume.fill(ParticleType::sediment, 0, 1, flat, height(0.06));
    flume.fill(ParticleType::water, 0, 0.45, height(0.06), height(0.2));
    flume.fill(ParticleType::water, 0.55, 1, height(0.06), height(0.2));
    if (pipe_bottom > 0.06) flume.fill(ParticleType::water, 0.45, 0.55, height(0.06), height(pipe_bottom));
    flume.fill(ParticleType::water, 0.45, 0.55, height(0.14), height(0.2));
    for (double x = 0.4525; x < 0.55; x += flume.spacing) {
      for (double z = pipe_bottom + 0.5 * flume.spacing; z < 0.14; z += flume.spacing) {
        flume.add(ParticleType::wall, {x, 0, z});
      }
    }
    const Profile profile = extract_profile(flume.set, {}).profile;
    EXPECT_NEAR(at(profile, profile.bed, 0.2), 0.06, 0.1 * flume.spacing);
    EXPECT_NEAR(at(profile, profile.bed, 0.5), pipe_bottom > 0.06 ? 0.06 : 0.14, 0.3 * flume.spacing);
    EXPECT_NEAR(at(profile, profile.free_surface, 0.5), 0.2, 0.1 * flume.spacing);
  }
}

TEST(ExtractProfile, TakesNoNoticeOfAGateLiftedAboveTheFlume) {
  Flume flume;
  flume.begin();
  flume.add_walls();
  flume.fill(ParticleType::water, 0, 1, flat, [](double) { return 0.16; });
  const ExtractedProfile without = extract_profile(flume.set, {});
  for (double x = 0.5025; x < 0.52; x += flume.spacing) {
    for (double z = 0.3025; z < 0.6; z += flume.spacing) flume.add(ParticleType::moving_wall, {x, 0, z});
  }
  const ExtractedProfile with_gate = extract_profile(flume.set, {});
  EXPECT_EQ(with_gate.profile.x, without.profile.x);
  EXPECT_EQ(with_gate.profile.free_surface, without.profile.free_surface);
}

TEST(ExtractProfile, MovingBedIsTheEdgeOfWhatRests) {
  Flume flume;
  flume.begin();
  flume.add_walls();
  const auto bed = [](double) { return 0.06; };
  const auto speed = [](double x, double z) { return x < 0.2 || z > 0.04 ? 0.1F : 1e-4F; };
  flume.fill(ParticleType::sediment, 0, 1, flat, bed, speed);
  flume.fill(ParticleType::water, 0, 1, bed, [](double) { return 0.12; });
  const double tolerance = 0.1 * flume.spacing;
  const Profile by_speed = extract_profile(flume.set, {}).profile;
  EXPECT_NEAR(at(by_speed, by_speed.moving_bed, 0.6), 0.04, tolerance);
  EXPECT_NEAR(at(by_speed, by_speed.bed, 0.6), 0.06, tolerance);
  EXPECT_NEAR(at(by_speed, by_speed.moving_bed, 0.1), 0, tolerance);  // all of it moves: the floor

  ExtractionSettings tolerant;
  tolerant.rest_speed = 0.2;
  const Profile all_rests = extract_profile(flume.set, tolerant).profile;
  EXPECT_NEAR(at(all_rests, all_rests.moving_bed, 0.6), 0.06, tolerance);

  // States override speed, as soon as any particle has one.
  flume.set.state.assign(flume.set.size(), SedimentState::none);
  EXPECT_FALSE(has_sediment_states(flume.set));
  for (std::size_t i = 0; i < flume.set.size(); ++i) {
    if (flume.set.type[i] != ParticleType::sediment) continue;
    flume.set.state[i] = flume.set.position[i].z() < 0.02 ? SedimentState::deposit : SedimentState::bed_load;
  }
  EXPECT_TRUE(has_sediment_states(flume.set));
  const Profile by_state = extract_profile(flume.set, {}).profile;
  EXPECT_NEAR(at(by_state, by_state.moving_bed, 0.6), 0.02, tolerance);
}

TEST(ExtractProfile, TakesThePlaneGivenInThreeDimensions) {
  Flume flume;
  flume.dimension = 3;
  flume.spacing = 0.01;
  flume.length = 0.3;
  flume.wall_height = 0.2;
  flume.begin();
  flume.add_walls();
  const auto bed = [](double) { return 0.05; };
  flume.fill(ParticleType::sediment, 0, 0.3, flat, bed);
  flume.fill(ParticleType::water, 0, 0.3, bed, [](double x) { return 0.1 + 0.1 * x; });
  ExtractionSettings settings;
  settings.plane_y = 0.05;
  const Profile profile = extract_profile(flume.set, settings).profile;
  const Misfit surface = misfit(
      profile.x, profile.free_surface, [](double x) { return 0.1 + 0.1 * x; }, 0.02, 0.28);
  EXPECT_LT(surface.largest, 0.1 * flume.spacing);
  EXPECT_LT(misfit(profile.x, profile.bed, bed, 0, 0.3).largest, 0.1 * flume.spacing);
}

TEST(ExtractProfile, WithoutWallsTheLargestBodyCounts) {
  Flume flume;
  flume.begin();
  flume.fill(ParticleType::water, 0, 1, flat, [](double) { return 0.1; });
  flume.fill(
      ParticleType::water, 0.4, 0.5, [](double) { return 0.2; }, [](double) { return 0.25; });
  flume.set.mass.clear();  // volumes then come from the lattice
  const ExtractedProfile found = extract_profile(flume.set, {});
  const Misfit error = misfit(
      found.profile.x, found.profile.free_surface, [](double) { return 0.1; }, 0.03, 0.97);
  EXPECT_LT(error.largest, 0.1 * flume.spacing);
}

TEST(ExtractProfile, AnEmptySetGivesAnEmptyProfileAndMissingFactsAreNamed) {
  Flume flume;
  flume.begin();
  EXPECT_TRUE(extract_profile(flume.set, {}).profile.x.empty());
  EXPECT_TRUE(std::isnan(extract_profile(flume.set, {}).front));
  flume.set.info.smoothing_length = 0;
  EXPECT_THROW(extract_profile(flume.set, {}), InputError);
}

}  // namespace
}  // namespace thalweg
