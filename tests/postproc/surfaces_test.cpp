// Surfaces: which bodies they show, what they carry, and their files.
#include "postproc/surfaces.hpp"

#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSTLReader.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/io/surface_file.hpp"
#include "tests/postproc/made_surfaces.hpp"
#include "tests/postproc/synthetic_run.hpp"

namespace thalweg {
namespace {

using manufactured::ball;
using manufactured::flat;
using manufactured::Flume;
using manufactured::Made;
using manufactured::surfaces_of;

TEST(Surfaces, FloatingGrainsAndDropsAreLeftOut) {
  for (const int dimension : {2, 3}) {
    Flume flume;
    flume.dimension = dimension;
    flume.length = 0.3;
    flume.begin();
    flume.add_walls();
    const auto bed = [](double) { return 0.05; };
    const auto surface = [](double) { return 0.12; };
    flume.fill(ParticleType::sediment, 0, 0.3, flat, bed);
    flume.fill(ParticleType::water, 0, 0.3, bed, surface);
    const Made before = surfaces_of(flume.set);
    // A clump of five cells' width among the water, which is more than half sediment in its middle, and a drop above.
    for (std::size_t i = 0; i < flume.set.size(); ++i) {
      const Vec3 at = flume.set.position[i] - Vec3(0.15, dimension == 2 ? 0 : 0.05, 0.085);
      if (flume.set.type[i] == ParticleType::water && at.cwiseAbs().maxCoeff() < 0.0125) {
        flume.set.type[i] = ParticleType::sediment;
      }
    }
    for (int n = 0; n < 125; ++n) {
      if (dimension == 2 && n % 5 != 0) continue;
      flume.add(ParticleType::water, Vec3(0.1, dimension == 2 ? 0 : 0.04, 0.2) +
                                         0.005 * Vec3(n / 25, dimension == 2 ? 0 : n % 5, n / 5 % 5));
    }
    const Made after = surfaces_of(flume.set);
    for (const SurfaceKind kind : {SurfaceKind::bed, SurfaceKind::free_surface}) {
      EXPECT_EQ(after[kind]->GetNumberOfPoints(), before[kind]->GetNumberOfPoints()) << name_of(kind);
      double highest = 0;
      for (vtkIdType i = 0; i < after[kind]->GetNumberOfPoints(); ++i) {
        highest = std::max(highest, after[kind]->GetPoint(i)[2]);
      }
      EXPECT_NEAR(highest, kind == SurfaceKind::bed ? 0.05 : 0.12, 0.1 * flume.spacing) << name_of(kind);
    }
  }
}

// A hole dug into a level bed: the surface's arrays say how deep, and so does the balance; the sediment that moves has
// another velocity than what rests.
TEST(Surfaces, CarryVelocityAndTheChangeOfTheBed) {
  const auto flume_with = [](const Flume::Height& bed) {
    Flume flume;
    flume.dimension = 3;
    flume.length = 0.4;
    flume.begin();
    flume.add_walls();
    flume.fill(ParticleType::sediment, 0, 0.4, flat, bed);
    flume.fill(
        ParticleType::water, 0, 0.4, bed, [](double) { return 0.12; }, [](double, double) { return 0.5F; });
    return flume.set;
  };
  const auto hole = [](double x) { return 0.06 - 0.02 * std::exp(-std::pow((x - 0.2) / 0.05, 2)); };
  const Made before = surfaces_of(flume_with([](double) { return 0.06; }));
  const ParticleSet set = flume_with(hole);
  const CellList cells(set.position, cell_edge(set.info));
  const auto field = make_surface_field({set, ExtractionSettings{}.rest_speed}, cells, {});
  const std::vector<Surface> surfaces = make_surfaces(set, cells, *field, before.map);
  vtkPolyData* bed = surfaces[1].data;
  vtkDataArray* change = bed->GetPointData()->GetArray("BedLevelChange");
  vtkDataArray* scour = bed->GetPointData()->GetArray("ScourDepth");
  ASSERT_NE(change, nullptr);
  int seen = 0;
  for (vtkIdType i = 0; i < bed->GetNumberOfPoints(); ++i) {
    Vec3 at;
    bed->GetPoint(i, at.data());
    if (std::abs(at.y() - 0.05) > 0.03 || at.z() < 0.03) continue;
    EXPECT_NEAR(change->GetTuple1(i), hole(at.x()) - 0.06, 0.25 * set.info.spacing);
    EXPECT_EQ(scour->GetTuple1(i), std::max(0.0, -change->GetTuple1(i)));
    ++seen;
  }
  EXPECT_GT(seen, 500);
  vtkDataArray* velocity = surfaces[0].data->GetPointData()->GetArray("Velocity");
  EXPECT_NEAR(velocity->GetComponent(velocity->GetNumberOfTuples() / 2, 0), 0.5, 1e-3);

  const std::optional<BedBalance> balance = bed_balance(before.map, level_map(*field));
  ASSERT_TRUE(balance);
  EXPECT_NEAR(balance->scour, 0.02, 0.1 * set.info.spacing);
  EXPECT_NEAR(balance->scour_at.x(), 0.2, 2 * set.info.spacing);
  // 0.02 m x 0.05 m sqrt(pi) across a flume 0.1 m wide, which ends in the open within a spacing on both sides.
  EXPECT_NEAR(balance->eroded, 0.02 * 0.05 * std::sqrt(std::numbers::pi) * 0.1, 0.12 * 1.77e-4);
  EXPECT_LT(balance->deposited, 1e-6);
}

// The grid's nodes lie on the floor's face and exactly a spacing below it, where rounding must not decide what a wall
// is.
TEST(Surfaces, StandOnTheFloorAtEverySpacing) {
  for (const double spacing : {0.01, 0.005, 0.004, 0.002}) {
    Flume flume;
    flume.dimension = 3;
    flume.spacing = spacing;
    flume.length = 20 * spacing;
    flume.width = 12 * spacing;
    flume.wall_height = 20 * spacing;
    flume.begin();
    flume.add_walls();
    flume.fill(ParticleType::sediment, 0, flume.length, flat, [&](double) { return 6 * spacing; });
    flume.fill(
        ParticleType::water, 0, flume.length, [&](double) { return 6 * spacing; },
        [&](double) { return 12 * spacing; });
    for (Vec3& at : flume.set.position) at = at.cast<float>().cast<double>();  // as in a snapshot
    const LevelMap map = surfaces_of(flume.set).map;
    for (std::size_t i = 0; i < map.grid.nx; ++i) {
      for (std::size_t j = 0; j < map.grid.ny; ++j) {
        const ColumnLevels& levels = map.levels[map.grid.column(i, j)];
        const bool open_side = std::abs(map.grid.y(j) - 6 * spacing) > 2.5 * spacing;
        if (open_side || std::isnan(levels.free_surface)) continue;
        EXPECT_NEAR(levels.floor, 0, 0.1 * spacing);
        EXPECT_NEAR(levels.bed, 6 * spacing, 0.1 * spacing);
      }
    }
  }
}

// A flume with a bed in its first half. Then its water has washed sand onto the bare half, and a piston under water
// stands where the bed was at the beginning.
TEST(Surfaces, WallsAreNoBed) {
  const auto scene = [](bool later) {
    Flume flume;
    flume.begin();
    flume.add_walls();
    const double piston = later ? 0.2 : 0;
    const auto bed = [&](double x) { return x < 0.5 ? 0.06 : later && x < 0.7 ? 0.03 : 0; };
    flume.fill(ParticleType::sediment, piston, 1, flat, bed);
    flume.fill(ParticleType::water, piston, 1, bed, [](double) { return 0.15; });
    if (!later) return flume.set;
    for (double x = 0.0025; x < piston; x += flume.spacing)
      for (double z = 0.0025; z < 0.1; z += flume.spacing) flume.add(ParticleType::moving_wall, {x, 0, z});
    flume.fill(
        ParticleType::water, 0, piston, [](double) { return 0.1; }, [](double) { return 0.15; });
    return flume.set;
  };
  const ParticleSet before = scene(false);
  const ParticleSet after = scene(true);
  const std::optional<BedBalance> balance = bed_balance(surfaces_of(before).map, surfaces_of(after).map);
  ASSERT_TRUE(balance);
  EXPECT_LT(balance->scour, 0.003);
  EXPECT_NEAR(balance->deposition, 0.03, 0.003);
  EXPECT_NEAR(balance->deposition_at.x(), 0.6, 0.11);
  EXPECT_NEAR(balance->deposited, 0.2 * 0.03, 0.1 * 0.2 * 0.03);

  const Profile profile = extract_profile(after, {}).profile;
  for (std::size_t i = 0; i < profile.x.size(); ++i) {
    if (profile.x[i] > 0.03 && profile.x[i] < 0.17) {
      EXPECT_TRUE(std::isnan(profile.bed[i])) << profile.x[i];
      EXPECT_NEAR(profile.floor[i], 0.1, 0.003);
    }
  }
  const vtkSmartPointer<vtkPolyData> bed = surfaces_of(after).surfaces.at(1).data;
  EXPECT_GT(bed->GetBounds()[0], 0.17);  // neither the piston's top
  EXPECT_LT(bed->GetBounds()[1], 0.73);  // nor the bare floor
}

TEST(Surfaces, AreWrittenAsVtpAndStl) {
  const manufactured::TemporaryFolder folder("surfaces");
  const ParticleSet set = ball(0.008, 0.04, 3);
  const Made made = surfaces_of(set);
  write_surface(folder.path() / "s.vtp", made.surfaces.front(), set.info);
  write_stl(folder.path() / "s.stl", made.surfaces.front());
  const PolygonSoup soup = read_vtp_surface(folder.path() / "s.vtp");
  EXPECT_EQ(soup.polygons.size(), static_cast<std::size_t>(made.surfaces.front().data->GetNumberOfPolys()));
  vtkNew<vtkSTLReader> reader;
  reader->SetFileName((folder.path() / "s.stl").c_str());
  reader->Update();
  EXPECT_EQ(static_cast<std::size_t>(reader->GetOutput()->GetNumberOfPolys()), soup.polygons.size());
}

}  // namespace
}  // namespace thalweg
