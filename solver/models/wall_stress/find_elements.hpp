#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "common/error.hpp"
#include "common/particles.hpp"
#include "solver/backend/buffer.hpp"
#include "solver/models/moving_walls/arrays.hpp"
#include "solver/models/wall_stress/arrays.hpp"
#include "solver/state/scene.hpp"

// The walls' surfaces, found once from the lattice that the walls stand on. A face of a wall particle is open if no wall
// particle stands at the lattice site beyond it. With f the sum of a particle's open faces (unit vectors)
//   n_j = sum_k w(r_jk) max(0, n_j . n_k) n_k, normalised; twice, from n = f/|f|
//   A_j = max(0, f_j . n_j) dp^(D-1)
//   d_j = mean of n_j . (x_F - x_j) over the middles x_F of the faces F around, weighted by w max(0, F . n_j)
// so that a plane's areas add up to its true area at any angle on the lattice, which |f| over-counts on stairs by up to
// 8 %, and the depths d lead to the plane itself. The factor n_j . n_k keeps a floor's normal upright beside a side wall.
// Walls of different motions do not see each other: what one uncovers when it moves is a surface of the other.
namespace thalweg {

/// Reach of the smoothing of normals [spacings]: the slopes 1:1 to 1:7 have their area within 1.2 %.
inline constexpr double normal_reach = 2.5;

template <int Dim>
class WallElementFinder {
 public:
  WallElementFinder(const Scene<Dim>& scene, const ParticleSet& from) : scene_(scene), from_(from) {
    const auto motions = from.scalars.find(motion_array);
    const auto started = from.doubles.find(field::moved_from.name);
    for (int k = 0; k < Dim; ++k) {
      if (scene.lattice.periodic[k]) period_[k] = std::llround(scene.lattice.range[k] / scene.spacing);
    }
    for (std::size_t i = 0; i < from.size(); ++i) {
      if (from.type[i] != ParticleType::wall && from.type[i] != ParticleType::moving_wall) continue;
      Vec3 x = from.position[i];
      if (started != from.doubles.end()) x = Vec3(started->second.data() + 3 * i);
      Site site{};
      for (int k = 0; k < Dim; ++k) {
        site[k] = wrapped(k, std::llround((x[axis<Dim>(k)] - scene.lattice_node[k]) / scene.spacing));
      }
      site[Dim] = motions == from.scalars.end() ? 0 : std::llround(motions->second[i]);
      walls_.emplace_back(site, i);
    }
    std::sort(walls_.begin(), walls_.end());
  }

  /// The elements of all particles, in the order of the file. Throws InputError where a wall has no sides.
  [[nodiscard]] HostBuffer<WallElement> find() const {
    const std::vector<Vector> faces = open_faces();
    std::vector<Vector> normals = faces;
    for (Vector& n : normals) normalise(n);
    for (int pass = 0; pass < 2; ++pass) normals = smoothed(normals);
    HostBuffer<WallElement> elements(from_.size(), WallElement{});
    const auto roughness = from_.scalars.find(roughness_array);
    const double cell_face = std::pow(scene_.spacing, Dim - 1);
    for (std::size_t w = 0; w < walls_.size(); ++w) {
      const std::size_t i = walls_[w].second;
      WallElement& element = elements[i];
      if (product(faces[w], normals[w]) <= 0) continue;
      element.area = static_cast<float>(product(faces[w], normals[w]) * cell_face);
      for (int k = 0; k < Dim; ++k) element.normal[axis<Dim>(k)] = static_cast<float>(normals[w][k]);
      element.depth = static_cast<float>(depth(w, normals[w], faces) * scene_.spacing);
      if (roughness != from_.scalars.end()) element.roughness = roughness->second[i];
    }
    return elements;
  }

 private:
  using Site = std::array<long long, Dim + 1>;  // lattice indices and the motion's number
  using Vector = std::array<double, Dim>;

  static double product(const Vector& a, const Vector& b) {
    double sum = 0;
    for (int k = 0; k < Dim; ++k) sum += a[k] * b[k];
    return sum;
  }
  static void normalise(Vector& n) {
    const double length = std::sqrt(product(n, n));
    if (length == 0) return;
    for (double& c : n) c /= length;
  }
  [[nodiscard]] long long wrapped(int k, long long index) const {
    return period_[k] == 0 ? index : (index % period_[k] + period_[k]) % period_[k];
  }

  /// Number of the wall at a site that lies `offset` from another, or -1.
  [[nodiscard]] std::ptrdiff_t beside(Site site, const std::array<int, Dim>& offset) const {
    for (int k = 0; k < Dim; ++k) site[k] = wrapped(k, site[k] + offset[k]);
    const auto found = std::lower_bound(walls_.begin(), walls_.end(), std::pair(site, std::size_t{0}));
    return found != walls_.end() && found->first == site ? found - walls_.begin() : -1;
  }

  /// Sum of the open faces of each wall particle. A particle whose faces cancel stands in a wall one particle thick,
  /// which has no sides; single ones are splinters of a shape.
  [[nodiscard]] std::vector<Vector> open_faces() const {
    std::vector<Vector> faces(walls_.size(), Vector{});
    std::size_t open = 0;
    std::size_t cancelled = 0;
    for (std::size_t w = 0; w < walls_.size(); ++w) {
      bool any = false;
      for (int k = 0; k < Dim; ++k) {
        for (const int side : {-1, 1}) {
          std::array<int, Dim> offset{};
          offset[k] = side;
          if (beside(walls_[w].first, offset) >= 0) continue;
          faces[w][k] += side;
          any = true;
        }
      }
      open += any ? 1 : 0;
      cancelled += any && product(faces[w], faces[w]) == 0 ? 1 : 0;
    }
    if (50 * cancelled > open) {
      throw InputError("model.wall_friction: " + std::to_string(cancelled) +
                       " wall particles stand in walls one particle thick, which have no sides that water could feel; "
                       "give these walls more thickness or make the spacing smaller");
    }
    return faces;
  }

  [[nodiscard]] std::vector<Vector> smoothed(const std::vector<Vector>& normals) const {
    std::vector<Vector> out = normals;
    for (std::size_t w = 0; w < walls_.size(); ++w) {
      if (product(normals[w], normals[w]) == 0) continue;
      Vector sum{};
      each_near(w, [&](std::size_t other, const Vector&, double weight) {
        const double alike = std::max(0.0, product(normals[w], normals[other]));
        for (int k = 0; k < Dim; ++k) sum[k] += weight * alike * normals[other][k];
      });
      normalise(sum);
      out[w] = sum;
    }
    return out;
  }

  /// Depth of a wall particle with the normal n below the surface [spacings].
  [[nodiscard]] double depth(std::size_t w, const Vector& n, const std::vector<Vector>& faces) const {
    double sum = 0;
    double weights = 0;
    each_near(w, [&](std::size_t other, const Vector& way, double weight) {
      for (int k = 0; k < Dim; ++k) {
        const double outward = faces[other][k] * n[k];
        if (outward <= 0) continue;
        sum += weight * outward * (product(n, way) + 0.5 * outward);
        weights += weight * outward;
      }
    });
    return weights > 0 ? sum / weights : 0.5;
  }

  /// Calls visit(number, way there in spacings, weight) for every wall particle of the same motion in reach.
  template <class Visit>
  void each_near(std::size_t w, const Visit& visit) const {
    std::array<int, Dim> offset{};
    each_offset(offset, 0, [&] {
      Vector way{};
      for (int k = 0; k < Dim; ++k) way[k] = offset[k];
      const double weight = 1 - product(way, way) / (normal_reach * normal_reach);
      const std::ptrdiff_t other = weight > 0 ? beside(walls_[w].first, offset) : -1;
      if (other >= 0) visit(static_cast<std::size_t>(other), way, weight);
    });
  }

  /// Calls visit() for every offset within the reach.
  template <class Visit>
  static void each_offset(std::array<int, Dim>& offset, int k, const Visit& visit) {
    constexpr int reach = static_cast<int>(normal_reach);
    for (offset[k] = -reach; offset[k] <= reach; ++offset[k]) {
      if (k + 1 < Dim) {
        each_offset(offset, k + 1, visit);
      } else {
        visit();
      }
    }
  }

  const Scene<Dim>& scene_;
  const ParticleSet& from_;
  std::array<long long, Dim> period_{};
  std::vector<std::pair<Site, std::size_t>> walls_;  // by site; number of the particle in the file
};

}  // namespace thalweg
