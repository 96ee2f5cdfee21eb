// Surfaces of known shape: how far the contours lie from them.
#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

#include "tests/postproc/made_surfaces.hpp"

namespace thalweg {
namespace {

using manufactured::ball;
using manufactured::flat;
using manufactured::Flume;
using manufactured::Made;
using manufactured::Misfit;
using manufactured::misfit;
using manufactured::promised;
using manufactured::surfaces_of;

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

}  // namespace
}  // namespace thalweg
