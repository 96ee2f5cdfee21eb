#include "postproc/surfaces.hpp"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSTLReader.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <numbers>

#include "common/io/surface_file.hpp"
#include "tests/postproc/manufactured.hpp"
#include "tests/postproc/synthetic_run.hpp"

namespace thalweg {
namespace {

using manufactured::Flume;

double flat(double) { return 0; }

struct Made {
  std::vector<Surface> surfaces;
  std::unique_ptr<SurfaceField> field;
  LevelMap map;

  [[nodiscard]] vtkPolyData* operator[](SurfaceKind kind) const {
    for (const Surface& surface : surfaces) {
      if (surface.kind == kind) return surface.data;
    }
    return nullptr;
  }
};

Made surfaces_of(const ParticleSet& set) {
  const CellList cells(set.position, cell_edge(set.info));
  Made made;
  made.field = make_surface_field({set, ExtractionSettings{}.rest_speed}, cells, {});
  made.map = level_map(*made.field);
  made.surfaces = make_surfaces(set, cells, *made.field, made.map);
  return made;
}

// Distance of a surface's points from the truth: root mean square and largest, over the points that `counts` names.
struct Misfit {
  double rms = 0;
  double largest = 0;
};
Misfit misfit(
    vtkPolyData* surface, const std::function<double(const Vec3&)>& distance,
    const std::function<bool(const Vec3&)>& counts = [](const Vec3&) { return true; }) {
  double sum = 0;
  Misfit error;
  int count = 0;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i) {
    Vec3 at;
    surface->GetPoint(i, at.data());
    if (!counts(at)) continue;
    const double off = distance(at);
    sum += off * off;
    error.largest = std::max(error.largest, std::abs(off));
    ++count;
  }
  EXPECT_GT(count, 20);
  error.rms = std::sqrt(sum / count);
  return error;
}

// A quarter of the spacing is what the surfaces promise; on a jittered lattice the noise of the sum's neighbours adds.
constexpr double promised = 0.25;

TEST(Surfaces, TiltedPlanesAreWithinAQuarterOfTheSpacingUpToTheWalls) {
  for (const int dimension : {2, 3}) {
    Flume flume;
    flume.dimension = dimension;
    flume.jitter = 0.2;
    flume.length = dimension == 2 ? 1 : 0.3;
    flume.begin();
    flume.add_walls();
    const auto bed = [](double x) { return 0.03 + 0.1 * x; };
    const auto surface = [](double x) { return 0.08 + 0.2 * x; };
    flume.fill(ParticleType::sediment, 0, flume.length, flat, bed);
    flume.fill(ParticleType::water, 0, flume.length, bed, surface);
    const Made made = surfaces_of(flume.set);
    // In 3-D the flume has no walls across y, where the fluid ends in the open.
    const auto inside = [&](const Vec3& at) { return dimension == 2 || std::abs(at.y() - 0.05) < 0.03; };
    const Misfit top = misfit(
        made[SurfaceKind::free_surface], [&](const Vec3& at) { return at.z() - surface(at.x()); },
        [&](const Vec3& at) { return inside(at) && at.z() > 0.04; });
    const Misfit low = misfit(
        made[SurfaceKind::bed], [&](const Vec3& at) { return at.z() - bed(at.x()); },
        [&](const Vec3& at) { return inside(at) && at.z() > 0.02; });
    EXPECT_LT(top.rms, promised * flume.spacing) << dimension;
    EXPECT_LT(low.rms, promised * flume.spacing) << dimension;
    EXPECT_LT(top.largest, flume.spacing) << dimension;
  }
}

// A bed of one wave length over the flume: the error falls at least as the spacing does.
TEST(Surfaces, ASineBedIsApproachedAtFirstOrderOrBetter) {
  for (const int dimension : {2, 3}) {
    double coarse = 0;
    for (const double spacing : {0.01, 0.005}) {
      Flume flume;
      flume.dimension = dimension;
      flume.spacing = spacing;
      flume.length = 0.4;
      flume.begin();
      flume.add_walls();
      const auto bed = [](double x) { return 0.07 + 0.015 * std::cos(2 * std::numbers::pi * x / 0.2); };
      flume.fill(ParticleType::sediment, 0, 0.4, flat, bed);
      flume.fill(ParticleType::water, 0, 0.4, bed, [](double) { return 0.14; });
      const Made made = surfaces_of(flume.set);
      const Misfit error = misfit(
          made[SurfaceKind::bed], [&](const Vec3& at) { return at.z() - bed(at.x()); },
          [&](const Vec3& at) {
            return at.z() > 0.045 && (dimension == 2 || std::abs(at.y() - 0.05) < 0.05 - 4 * spacing);
          });
      EXPECT_LT(error.rms, promised * spacing) << dimension;
      if (coarse > 0) {
        EXPECT_LT(error.rms, 0.55 * coarse) << dimension;
      }
      coarse = error.rms;
    }
  }
}

// A ball of water in the air: its particles' volumes are the shares of their lattice cells inside the ball, counted on
// an 8 x 8 x 8 sub-lattice.
ParticleSet ball(double spacing, double radius, int dimension) {
  Flume flume;
  flume.dimension = dimension;
  flume.spacing = spacing;
  flume.begin();
  const long reach = std::lround(std::ceil(radius / spacing));
  const int parts = 8;
  for (long i = -reach; i < reach; ++i) {
    for (long j = dimension == 2 ? 0 : -reach; j < (dimension == 2 ? 1 : reach); ++j) {
      for (long k = -reach; k < reach; ++k) {
        Vec3 sum = Vec3::Zero();
        int count = 0;
        for (int n = 0; n < parts * parts * (dimension == 2 ? 1 : parts); ++n) {
          const auto at = [&](long cell, int part) {
            return (static_cast<double>(cell) + (part + 0.5) / parts) * spacing;
          };
          const Vec3 point(at(i, n % parts), dimension == 2 ? 0 : at(j, n / (parts * parts)), at(k, n / parts % parts));
          if (point.norm() > radius) continue;
          sum += point;
          ++count;
        }
        if (count == 0) continue;
        flume.add(ParticleType::water, sum / count, count / std::pow(parts, dimension));
      }
    }
  }
  return flume.set;
}

TEST(Surfaces, ABallIsRoundAndConvergesAtFirstOrderOrBetter) {
  for (const int dimension : {2, 3}) {
    const double radius = 0.04;
    double coarse = 0;
    for (const double spacing : {0.008, 0.004}) {
      const Made made = surfaces_of(ball(spacing, radius, dimension));
      const Misfit error = misfit(made[SurfaceKind::free_surface], [&](const Vec3& at) { return at.norm() - radius; });
      EXPECT_LT(error.rms, promised * spacing) << dimension;
      if (coarse > 0) {
        EXPECT_LT(error.rms, 0.55 * coarse) << dimension;
      }
      coarse = error.rms;
    }
  }
}

TEST(Surfaces, TrianglesAndNormalsPointOutOfTheFluid) {
  const Made made = surfaces_of(ball(0.008, 0.04, 3));
  vtkPolyData* surface = made[SurfaceKind::free_surface];
  vtkDataArray* normals = surface->GetPointData()->GetNormals();
  ASSERT_NE(normals, nullptr);
  ASSERT_GT(surface->GetNumberOfPolys(), 100);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i) {
    Vec3 at;
    surface->GetPoint(i, at.data());
    Vec3 normal;
    normals->GetTuple(i, normal.data());
    EXPECT_GT(normal.dot(at.normalized()), 0.9);
  }
  vtkIdType count = 0;
  const vtkIdType* corners = nullptr;
  vtkCellArray* cells = surface->GetPolys();
  for (cells->InitTraversal(); cells->GetNextCell(count, corners) != 0;) {
    std::array<Vec3, 3> p;
    for (std::size_t c = 0; c < 3; ++c) surface->GetPoint(corners[c], p[c].data());
    const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]);
    if (normal.norm() > 1e-12) {
      EXPECT_GT(normal.dot(p[0]), 0);
    }
  }
}

// A breaking wave: a lip of water, half a ring, that arches over a trough of air and ends above still water. The
// surface has both sides of the lip; columns under it have three crossings.
TEST(Surfaces, AnOverhangingWaveShowsBothSidesOfItsLip) {
  const double inner = 0.05;
  const double outer = 0.08;
  const Vec3 centre(0.25, 0, 0.06);
  for (const int dimension : {2, 3}) {
    double coarse = 0;
    for (const double spacing : {0.01, 0.005}) {
      Flume flume;
      flume.dimension = dimension;
      flume.spacing = spacing;
      flume.length = 0.5;
      flume.begin();
      flume.add_walls();
      flume.fill(ParticleType::water, 0, 0.5, flat, [](double) { return 0.06; });
      const int parts = 8;
      for (long i = 0; i < std::lround(0.35 / spacing); ++i) {
        for (long k = std::lround(0.06 / spacing); k < std::lround(0.16 / spacing); ++k) {
          Vec3 sum = Vec3::Zero();
          int count = 0;
          for (int n = 0; n < parts * parts; ++n) {
            const Vec3 point((static_cast<double>(i) + (n % parts + 0.5) / parts) * spacing, 0,
                             (static_cast<double>(k) + (n / parts + 0.5) / parts) * spacing);
            const double r = (point - centre).norm();
            const bool in_lip = r > inner && r < outer && (point.x() < centre.x() || point.z() > centre.z() + 0.035);
            if (!in_lip) continue;
            sum += point;
            ++count;
          }
          if (count == 0) continue;
          for (int j = 0; j < (dimension == 2 ? 1 : std::lround(flume.width / spacing)); ++j) {
            Vec3 at = sum / count;
            if (dimension == 3) at.y() = (j + 0.5) * spacing;
            flume.add(ParticleType::water, at, count / double{parts * parts});
          }
        }
      }
      const Made made = surfaces_of(flume.set);
      // Of the lip alone: above the root, where its two arcs are all there is.
      const auto on_lip = [&](const Vec3& at) {
        return at.z() > 0.1 && at.x() < 0.28 && (dimension == 2 || std::abs(at.y() - 0.05) < 0.05 - 4 * spacing);
      };
      const Misfit error = misfit(
          made[SurfaceKind::free_surface],
          [&](const Vec3& at) {
            const double r = (Vec3(at.x(), 0, at.z()) - centre).norm();
            return std::min(std::abs(r - inner), std::abs(r - outer));
          },
          on_lip);
      EXPECT_LT(error.rms, promised * spacing) << dimension;
      if (coarse > 0) {
        EXPECT_LT(error.rms, 0.6 * coarse) << dimension;
      }
      coarse = error.rms;
      // Both arcs are there, over the same x.
      int under = 0;
      int over = 0;
      for (vtkIdType p = 0; p < made[SurfaceKind::free_surface]->GetNumberOfPoints(); ++p) {
        Vec3 at;
        made[SurfaceKind::free_surface]->GetPoint(p, at.data());
        if (std::abs(at.x() - 0.25) > 0.01 || at.z() < 0.09) continue;
        ++(at.z() < centre.z() + 0.065 ? under : over);
      }
      EXPECT_GT(under, 0);
      EXPECT_GT(over, 0);
    }
  }
}

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
