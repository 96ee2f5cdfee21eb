#pragma once

#include <cmath>
#include <vector>

#include "physics/transport/wall_stress.hpp"
#include "solver/models/implicit/viscous_system.hpp"
#include "solver/models/moving_walls/arrays.hpp"
#include "solver/models/moving_walls/wall_motion.hpp"
#include "solver/models/wall_stress/arrays.hpp"
#include "solver/passes/sweep.hpp"

// Shear stress of turbulent water on walls. An element j is a wall particle with a share A of the surface and a normal n
// at the depth d below that surface (find_elements.hpp). Over the water in its reach, m0 = sum_b V_b W,
//   u    = sum_b V_b W u_b/m0 - u_j, its part across n taken off
//   mean = sum_b V_b W n.(x_b - x_j)/m0 - d, and the variance of the same heights
//   tau  = rho u*^2,  u* by the law of the wall (physics/transport/wall_stress.hpp)
// and the water particle b gets the force per volume -tau (u/|u|) A W_bj/m0: its sum over the water is tau A to
// rounding, whatever the spacing, the kernel or the disorder of the particles.
namespace thalweg {

/// Pair sweep over the walls: what each element does to the water, into the wall's work quad.
template <int Dim>
struct WallElementSweep {
  using neighbours = Neighbours<field::place, field::flow, field::matter>;
  using reads = Reads<field::place, field::flow, field::wall_element, field::wall_normal>;
  using writes = Writes<field::wall_traction, field::wall_shear>;
  static constexpr unsigned kernel = kernel_value;
  template <class L>
  struct Sum {
    L fluid;  // of V W
    L water;
    Vec<Dim, L> velocity;           // of V W u of water
    Vec<Dim, L> first;              // of V W r of water, r = x_b - x_j
    L second[Dim * (Dim + 1) / 2];  // of V W r (x) r of water, upper triangle row by row
  };

  Record* records;
  const WallElement* elements;
  const WallNormal* turned;  // nullptr: no wall moves
  WallShear* shear;          // nullptr: nobody asks for it
  Scene<Dim> scene;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT&, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    const L weight = b.volume * g.W;
    const L of_water = lane_select(is_water(b), weight, L(0.0F));
    sum.fluid += lane_select(is_wall(b), L(0.0F), weight);
    sum.water += of_water;
    int m = 0;
    for (int k = 0; k < Dim; ++k) {
      const L weighted = of_water * g.r[k];
      sum.velocity[k] += of_water * b.velocity[k];
      sum.first[k] += -weighted;
      for (int l = k; l < Dim; ++l) sum.second[m++] += weighted * g.r[l];
    }
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    Record& wall = records[i];
    for (float& w : wall.work) w = 0;
    if (shear != nullptr) shear[i] = WallShear{};
    const WallElement& element = elements[i];
    // Water at the kernel's very edge: its weights may be 1e-30, whose products and quotients single precision cannot hold.
    if (!(element.area > 0 && sum.water > 1e-6F && wall.volume > 0)) return;
    const Vec<Dim, float> n = normal(i);
    Vec<Dim, float> u{};
    for (int k = 0; k < Dim; ++k) u[k] = sum.velocity[k] / sum.water - wall.velocity[axis<Dim>(k)];
    const float across = dot(u, n);
    for (int k = 0; k < Dim; ++k) u[k] -= across * n[k];
    const float speed = std::sqrt(dot(u, u));
    if (!(speed > 0)) return;
    const float stress = stress_over_density(sum, n, speed, element);
    const float force = scene.water_density * stress * element.area * wet_share(sum);
    for (int k = 0; shear != nullptr && k < Dim; ++k) {
      shear[i].of[axis<Dim>(k)] = force / element.area * u[k] / speed;
    }
    for (int k = 0; k < Dim; ++k) wall.work[axis<Dim>(k)] = -force * u[k] / (speed * sum.water * wall.volume);
  }

 private:
  [[nodiscard]] HOST_DEVICE Vec<Dim, float> normal(Index i) const {
    const float* from = turned == nullptr ? elements[i].normal : turned[i].of;
    Vec<Dim, float> n{};
    for (int k = 0; k < Dim; ++k) n[k] = from[axis<Dim>(k)];
    return n;
  }

  /// tau/rho [m^2/s^2], at most what slows the water in one step by its whole speed (most_drag).
  HOST_DEVICE float stress_over_density(const Sum<float>& sum, const Vec<Dim, float>& n, float speed,
                                        const WallElement& element) const {
    const auto dp = static_cast<float>(scene.spacing);
    const float height = dot(sum.first, n) / sum.water;
    float square = 0;
    int m = 0;
    for (int k = 0; k < Dim; ++k) {
      for (int l = k; l < Dim; ++l) square += (k == l ? 1.0F : 2.0F) * n[k] * n[l] * sum.second[m++];
    }
    const float variance = square / sum.water - height * height;
    // In a notch of the surface the water's mean may lie below it.
    const float mean = height - element.depth > 0.1F * dp ? height - element.depth : 0.1F * dp;
    const float z = log_mean_height(mean, variance > 0 ? variance : 0.0F);
    const float found = wall_friction_velocity(speed, mean, z, scene.wall_stress.viscosity, element.roughness);
    const float most = speed * scene.wall_stress.most_drag;
    return found * found < most ? found * found : most;
  }

  /// Share of the element that touches water: the rest is covered by sediment, or dry where less than half a layer of
  /// water is in reach.
  [[nodiscard]] HOST_DEVICE float wet_share(const Sum<float>& sum) const {
    const float share = sum.water / sum.fluid;
    return sum.water < scene.wall_stress.contact ? share * sum.water / scene.wall_stress.contact : share;
  }
};

/// Pair sweep over the fluid near walls: the water takes what the elements do to it.
template <int Dim>
struct WallDragSweep {
  using neighbours = Neighbours<field::place, field::matter, field::wall_traction>;
  using reads = Reads<field::place, field::matter, field::mass, field::rates>;
  using writes = Writes<field::rates>;
  static constexpr unsigned kernel = kernel_value;
  template <class L>
  struct Sum {
    Vec<Dim, L> force;  // per volume [N/m^3]
  };

  const Record* records;
  const float* mass;
  Rates* rates;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT&, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    const L weight = lane_select(is_wall(b), b.volume * g.W, L(0.0F));
    for (int k = 0; k < Dim; ++k) sum.force[k] += weight * b.work[k];
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    const Record& r = records[i];
    if (!is_water(r)) return;
    const float specific_volume = r.volume / mass[i];
    for (int k = 0; k < Dim; ++k) rates[i].acceleration[axis<Dim>(k)] += sum.force[k] * specific_volume;
  }
};

/// Particle pass over the walls of one motion that turns: their normals as they stand now.
struct TurnNormalsPass {
  using reads = Reads<field::motion, field::wall_element>;
  using writes = Writes<field::wall_normal>;

  const Index* motion;
  const WallElement* elements;
  WallNormal* normals;
  Index number;      // of the motion
  RigidAxis axis;    // through the origin: a direction has no place
  double angle = 0;  // [rad]
  Index first;       // wall particle

  HOST_DEVICE void operator()(Index n) const {
    const Index i = first + n;
    if (motion[i] != number) return;
    double from[3];
    double to[3];
    for (int c = 0; c < 3; ++c) from[c] = double(elements[i].normal[c]);
    moved_point(axis, angle, from, to);
    for (int c = 0; c < 3; ++c) normals[i].of[c] = static_cast<float>(to[c]);
  }
};

/// Normals of the walls that turn, at the time t [s].
template <class Device>
void turn_normals(Device& on, Particles<Device>& p, const std::vector<WallMotion>& motions, double t) {
  for (std::size_t m = 0; m < motions.size(); ++m) {
    if (!motions[m].axis.turns) continue;
    RigidAxis axis = motions[m].axis;
    for (double& c : axis.center) c = 0;
    on.for_each(p.count - p.fluid_count,
                TurnNormalsPass{p.motion.data(), p.wall_element.data(), p.wall_normal.data(), static_cast<Index>(m + 1),
                                axis, motions[m].at(t).place, p.fluid_count});
  }
}

/// Adds the walls' shear stress to the accelerations. The viscous solve takes the work quads of walls for zero
/// (models/implicit/viscous_system.hpp), so that they are cleared for it.
template <int Dim, class Device>
void add_wall_stress(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  Record* records = p.record.data();
  const WallNormal* turned = p.wall_normal.size() == 0 ? nullptr : p.wall_normal.data();
  WallShear* shear = scene.keeps_wall_shear ? p.wall_shear.data() : nullptr;
  sweep(on, p, scene, p.walls_near_fluid(),
        WallElementSweep<Dim>{records, p.wall_element.data(), turned, shear, scene});
  sweep(on, p, scene, p.near_walls(), WallDragSweep<Dim>{records, p.mass.data(), p.rates.data()});
  if (!scene.has_sediment) return;
  const Index first = p.fluid_count;
  on.for_each(p.count - first, declare<Reads<>, Writes<field::viscous_vector>>([=] HOST_DEVICE(Index n) {
                for (float& w : records[first + n].work) w = 0;
              }));
}

}  // namespace thalweg
