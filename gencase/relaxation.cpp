#include "gencase/relaxation.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "gencase/hydrostatic.hpp"
#include "physics/kernel.hpp"

namespace thalweg::gencase {
namespace {

constexpr std::int32_t no_particle = -1;

class ParticleShifting {
 public:
  ParticleShifting(ParticleSet& particles, const std::vector<PlacedShape>& shapes, const SkinSearch& skin,
                   const Filling& filling)
      : particles_(particles), shapes_(shapes), skin_(skin), filling_(filling), lattice_(filling.lattice) {
    find_nodes();
    find_offsets();
    choose_particles();
  }

  Relaxation run(int sweeps, double gravity, double sound_speed) {
    Relaxation result;
    result.particles = static_cast<std::int64_t>(movable_.size());
    step_back_at_surface(result, gravity, sound_speed);
    if (movable_.empty()) return result;
    const std::vector<Vec3> start = places();
    for (const std::size_t i : movable_) result.too_near += is_too_near(particles_.position[i]);
    for (const std::size_t i : movable_) particles_.position[i] = stepped_back(particles_.position[i]);
    result.before = result.after = compute_gradients();
    while (result.sweeps < sweeps && result.after > 0) {
      move(start);
      ++result.sweeps;
      const double unevenness = compute_gradients();
      const bool stalls = unevenness > 0.999 * result.after;
      result.after = unevenness;
      if (stalls) break;
    }
    for (std::size_t m = 0; m < movable_.size(); ++m) {
      const Vec3 way = particles_.position[movable_[m]] - start[m];
      result.farthest = std::max(result.farthest, way.norm());
      update_hydrostatics(movable_[m], gravity * way[lattice_.axes[2]], sound_speed);
    }
    return result;
  }

 private:
  /// Fluid beside a wall and the free surface steps back from the wall but is not shifted: there the kernel sum does
  /// not tell how even the particles stand, because it lacks the part above the surface.
  void step_back_at_surface(Relaxation& result, double gravity, double sound_speed) {
    for (const std::size_t i : at_surface_) {
      const Vec3 way = stepped_back(particles_.position[i]) - particles_.position[i];
      if (way.isZero(0)) continue;
      ++result.too_near;
      result.farthest = std::max(result.farthest, way.norm());
      particles_.position[i] += way;
      update_hydrostatics(i, gravity * way[lattice_.axes[2]], sound_speed);
    }
  }

  /// Pressure, density and mass of rest at the new place. `potential` [m^2/s^2]: gravity times the way along it,
  /// positive downward.
  void update_hydrostatics(std::size_t i, double potential, double sound_speed) {
    const double rest = shapes_[filling_.label[static_cast<std::size_t>(node_of_[i])] - 1U].density_at_rest;
    const double pressure = std::max(0.0, particles_.pressure[i] + rest * potential);
    const double density = hydrostatic_density(rest, pressure, sound_speed);
    particles_.pressure[i] = static_cast<float>(pressure);
    particles_.density[i] = static_cast<float>(density);
    particles_.mass[i] = static_cast<float>(density * lattice_.cell());
  }

  [[nodiscard]] double least_distance() const { return 0.5 * lattice_.spacing * (1 - 1e-6); }
  [[nodiscard]] bool is_too_near(const Vec3& place) const { return skin_.find(place, least_distance()).has_value(); }

  /// The place, moved to half a spacing from the nearest skin if it is nearer than that.
  [[nodiscard]] Vec3 stepped_back(const Vec3& place) const {
    const auto near = skin_.find(place, least_distance());
    if (!near || near->distance < 1e-9 * lattice_.spacing) return place;
    return place - (0.5 * lattice_.spacing - near->distance) * near->direction;
  }

  /// Finds the node of each particle: generate() makes the particles in the order of the nodes.
  void find_nodes() {
    at_node_.assign(filling_.label.size(), no_particle);
    std::int32_t next = 0;
    for (std::size_t node = 0; node < filling_.label.size(); ++node) {
      if (filling_.label[node] == nothing || filling_.label[node] == solid_core) continue;
      at_node_[node] = next++;
      node_of_.push_back(static_cast<std::int64_t>(node));
    }
  }

  /// Finds the steps to all nodes whose particles may lie within the support after both have moved by half a spacing.
  void find_offsets() {
    const double h = particles_.info.smoothing_length;
    const int reach = static_cast<int>(std::ceil(2 * h / lattice_.spacing)) + 1;
    const int across = lattice_.dimension == 2 ? 0 : reach;
    for (int x = -reach; x <= reach; ++x)
      for (int y = -across; y <= across; ++y)
        for (int z = -reach; z <= reach; ++z)
          if (const int r2 = x * x + y * y + z * z; r2 > 0 && r2 <= reach * reach) offsets_.push_back({x, y, z});
    support_ = 2 * h;
  }

  /// Label of a node; `nothing` outside of the lattice.
  [[nodiscard]] Label label_at(const Index3& at) const {
    for (int axis = 0; axis < 3; ++axis)
      if (at[axis] < 0 || at[axis] >= lattice_.count[axis]) return nothing;
    return filling_.label[static_cast<std::size_t>(lattice_.flat(at))];
  }

  /// Sorts the fluid particles beside walls into those that may be shifted and those at the free surface.
  void choose_particles() {
    for (std::size_t i = 0; i < node_of_.size(); ++i) {
      if (!shapes_[filling_.label[static_cast<std::size_t>(node_of_[i])] - 1U].is_fluid()) continue;
      const Index3 here = lattice_.offset(node_of_[i]);
      bool sees_wall = false;
      bool sees_surface = false;
      for (const Index3& step : offsets_) {
        const double distance = lattice_.spacing * std::hypot(step[0], step[1], step[2]);
        if (distance >= support_) continue;
        const Label label = label_at({here[0] + step[0], here[1] + step[1], here[2] + step[2]});
        sees_surface = sees_surface || label == nothing;
        sees_wall = sees_wall || (label != nothing && label != solid_core && shapes_[label - 1U].is_wall());
      }
      if (sees_wall) (sees_surface ? at_surface_ : movable_).push_back(i);
    }
    gradients_.resize(movable_.size());
  }

  [[nodiscard]] std::vector<Vec3> places() const {
    std::vector<Vec3> result;
    for (const std::size_t i : movable_) result.push_back(particles_.position[i]);
    return result;
  }

  /// Sum of V grad W over a particle's neighbours [1/m].
  [[nodiscard]] Vec3 gradient(std::size_t i) const { return lattice_.dimension == 2 ? gradient<2>(i) : gradient<3>(i); }

  template <int Dim>
  [[nodiscard]] Vec3 gradient(std::size_t i) const {
    const WendlandC2<Dim, double> kernel(particles_.info.smoothing_length);
    const Index3 here = lattice_.offset(node_of_[i]);
    Vec3 sum = Vec3::Zero();
    for (const Index3& step : offsets_) {
      const Index3 at{here[0] + step[0], here[1] + step[1], here[2] + step[2]};
      const Label label = label_at(at);
      if (label == nothing || label == solid_core) continue;
      const std::int32_t j = at_node_[static_cast<std::size_t>(lattice_.flat(at))];
      const Vec3 arm = particles_.position[i] - particles_.position[static_cast<std::size_t>(j)];
      sum += kernel.gradient(closeness_by_support(arm.norm(), support_)) * arm;
    }
    return lattice_.cell() * sum;
  }

  /// Root mean square of h |gradient|.
  double compute_gradients() {
    tbb::parallel_for(std::size_t{0}, movable_.size(), [&](std::size_t m) { gradients_[m] = gradient(movable_[m]); });
    double sum = 0;
    for (const Vec3& g : gradients_) sum += g.squaredNorm();
    return particles_.info.smoothing_length * std::sqrt(sum / static_cast<double>(gradients_.size()));
  }

  void move(const std::vector<Vec3>& start) {
    // The shift is this factor [m^2] times the gradient: 0.1 h^2, so that neighbours that shift at the same time do not
    // overshoot; and at most a tenth of the spacing in one sweep.
    const double strength = 0.1 * particles_.info.smoothing_length * particles_.info.smoothing_length;
    tbb::parallel_for(std::size_t{0}, movable_.size(), [&](std::size_t m) {
      Vec3& place = particles_.position[movable_[m]];
      Vec3 shift = -strength * gradients_[m];
      const double length = shift.norm();
      if (length > 0.1 * lattice_.spacing) shift *= 0.1 * lattice_.spacing / length;
      const Vec3 to = stepped_back(place + shift);
      if ((to - start[m]).norm() <= lattice_.spacing && !is_too_near(to)) place = to;
    });
  }

  ParticleSet& particles_;
  const std::vector<PlacedShape>& shapes_;
  const SkinSearch& skin_;
  const Filling& filling_;
  const Lattice& lattice_;
  std::vector<std::int32_t> at_node_;  // particle at each node
  std::vector<std::int64_t> node_of_;  // of each particle
  std::vector<Index3> offsets_;
  double support_ = 0;  // [m]
  std::vector<std::size_t> movable_;
  std::vector<std::size_t> at_surface_;  // beside a wall and the free surface
  std::vector<Vec3> gradients_;          // of movable particles
};

}  // namespace

Relaxation relax(ParticleSet& particles, const std::vector<PlacedShape>& shapes, const SkinSearch& skin,
                 const Filling& filling, int sweeps, double gravity, double sound_speed) {
  return ParticleShifting(particles, shapes, skin, filling).run(sweeps, gravity, sound_speed);
}

}  // namespace thalweg::gencase
