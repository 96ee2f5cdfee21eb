#include "gencase/nearest_surface.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <span>

namespace thalweg::gencase {
namespace {

using Few = std::span<const Surface* const>;  // one to three surfaces
using Gradients = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor, 3, 3>;
using Values = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 3, 1>;
using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 3, 3>;

// Surfaces with a smaller squared sine of their angle are taken as parallel: they have no edge in common.
constexpr double parallel = 1e-8;

Gradients gradients(Few surfaces, const Vec3& at) {
  Gradients rows(surfaces.size(), 3);
  for (std::size_t i = 0; i < surfaces.size(); ++i) rows.row(i) = surfaces[i]->gradient(at).transpose();
  return rows;
}

Values distances(Few surfaces, const Vec3& at) {
  Values values(surfaces.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i) values[i] = surfaces[i]->signed_distance(at);
  return values;
}

/// Foot q of the perpendicular from `from` to the intersection of all surfaces: it minimises |q - from| while every
/// signed distance d is 0. Repeated linearisation, exact after one iteration for planes:
///   q = from + N^T (N N^T)^-1 (N (q - from) - d), N the matrix of the gradients.
/// Nothing if it does not converge or the surfaces are parallel.
std::optional<Vec3> foot(Few surfaces, const Vec3& from, double length) {
  if (surfaces.size() == 1) return from - surfaces[0]->signed_distance(from) * surfaces[0]->gradient(from);
  Vec3 q = from;
  for (int iteration = 0; iteration < 60; ++iteration) {
    const Gradients n = gradients(surfaces, q);
    const Square angles = n * n.transpose();
    if (angles.determinant() < parallel) return std::nullopt;
    const Vec3 next = from + n.transpose() * angles.inverse() * (n * (q - from) - distances(surfaces, q));
    const double step = (next - q).norm();
    q = next;
    if (step < 1e-12 * length) return q;
  }
  return std::nullopt;
}

/// True if some, but not all, of the 2^k sectors into which k surfaces divide the neighbourhood of `at` lie in the set.
bool on_skin(const PointSet& set, Few surfaces, const Vec3& at, double length) {
  const double probe = 1e-4 * length;  // far above rounding, far below any detail
  const Gradients n = gradients(surfaces, at);
  const Square inverse = Square(n * n.transpose()).inverse();
  bool some_inside = false;
  bool some_outside = false;
  for (unsigned sector = 0; sector < (1U << surfaces.size()); ++sector) {
    Values sides(surfaces.size());
    for (std::size_t i = 0; i < surfaces.size(); ++i) sides[i] = (sector >> i & 1U) ? probe : -probe;
    const Vec3 sample = at + n.transpose() * (inverse * sides);
    (set.contains(sample) ? some_inside : some_outside) = true;
    if (some_inside && some_outside) return true;
  }
  return false;
}

}  // namespace

NearestSurface::NearestSurface(const PointSet& set, double length) : set_(set), length_(length) {
  set.append_surfaces(surfaces_);
}

std::optional<SurfacePoint> NearestSurface::find(const Vec3& from, double reach) const {
  struct Near {
    double distance;
    const Surface* surface;
  };
  // A surface farther away than the best skin point found so far cannot hold a nearer one.
  std::vector<Near> near;
  near.reserve(surfaces_.size());
  for (const Surface* surface : surfaces_)
    if (const double distance = std::abs(surface->signed_distance(from)); distance < reach)
      near.push_back({distance, surface});
  std::sort(near.begin(), near.end(), [](const Near& a, const Near& b) { return a.distance < b.distance; });

  double best = reach;
  std::optional<SurfacePoint> found;
  const auto consider = [&](Few surfaces) {
    const auto q = foot(surfaces, from, length_);
    if (!q) return;
    const double distance = (*q - from).norm();
    if (distance >= best || !on_skin(set_, surfaces, *q, length_)) return;
    best = distance;
    const bool on_it = distance < 1e-9 * length_;
    found = SurfacePoint{*q, on_it ? surfaces[0]->gradient(from) : Vec3((*q - from) / distance), distance};
  };
  for (std::size_t i = 0; i < near.size() && near[i].distance < best; ++i) consider(std::array{near[i].surface});
  for (std::size_t j = 1; j < near.size() && near[j].distance < best; ++j)
    for (std::size_t i = 0; i < j; ++i) {
      consider(std::array{near[i].surface, near[j].surface});
      for (std::size_t k = 0; k < i; ++k) consider(std::array{near[k].surface, near[i].surface, near[j].surface});
    }
  return found;
}

}  // namespace thalweg::gencase
