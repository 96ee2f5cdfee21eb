#pragma once

#include <gtest/gtest.h>
#include <vtkPolyData.h>

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "postproc/surfaces.hpp"
#include "tests/postproc/manufactured.hpp"

namespace thalweg::manufactured {

/// The surfaces of a set, and the field and heights they come from.
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

inline Made surfaces_of(const ParticleSet& set) {
  const CellList cells(set.position, cell_edge(set.info));
  Made made;
  made.field = make_surface_field({set, ExtractionSettings{}.rest_speed}, cells, {});
  made.map = level_map(*made.field);
  made.surfaces = make_surfaces(set, cells, *made.field, made.map);
  return made;
}

/// Distance of a surface's points from the truth: root mean square and largest, over the points that `counts` names.
struct Misfit {
  double rms = 0;
  double largest = 0;
};
inline Misfit misfit(
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

/// A quarter of the spacing is what the surfaces promise; on a jittered lattice the noise of the sum's neighbours adds.
inline constexpr double promised = 0.25;

/// A ball of water in the air: its particles' volumes are the shares of their lattice cells inside the ball, counted on
/// an 8 x 8 x 8 sub-lattice.
inline ParticleSet ball(double spacing, double radius, int dimension) {
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

}  // namespace thalweg::manufactured
