#pragma once

#include <cmath>
#include <random>

#include "common/particles.hpp"
#include "solver/models/all.hpp"

// Small scenes made by hand for the solver's tests: 2-D and 3-D lattices, with or without jitter, periodic or not.
namespace thalweg::test {

template <int Dim>
struct LatticeSetup {
  double spacing = 0.01;
  double smoothing_ratio = 1.5;
  double length = 0.2;      // edge of the cubic domain [m]
  double sound_speed = 20;  // [m/s]
  bool periodic = false;
  double skin = 0.1;
  Vec<Dim, float> gravity{};
};

template <int Dim>
Scene<Dim> make_scene_of(const LatticeSetup<Dim>& setup) {
  Scene<Dim> s;
  const double h = setup.smoothing_ratio * setup.spacing;
  s.spacing = setup.spacing;
  s.smoothing_length = h;
  s.list_reach = 2 * h * (1 + setup.skin);
  s.kernel = WendlandC2<Dim, float>(static_cast<float>(h));
  s.no_slip = NoSlip<Dim>(h, s.spacing);
  s.singularity = static_cast<float>(0.01 * h * h);
  bool periodic[Dim];
  Vec<Dim, double> to{};
  for (int k = 0; k < Dim; ++k) periodic[k] = setup.periodic, to[k] = setup.length;
  s.domain_from = Vec<Dim, double>{};
  s.domain_to = to;
  for (int k = 0; k < Dim; ++k) s.lattice_node[k] = s.domain_from[k] + 0.5 * setup.spacing;
  s.lattice = Lattice<Dim>(s.domain_from, to, periodic, s.list_reach);
  s.gravity = setup.gravity;
  s.sound_speed = static_cast<float>(setup.sound_speed);
  s.water_density = 1000;
  s.sediment_density = 1300;
  s.water_viscosity = 1e-3F;
  s.diffusion = static_cast<float>(2 * 0.1 * h * setup.sound_speed);
  s.artificial_viscosity = static_cast<float>(0.02 * h * setup.sound_speed);
  s.cfl = 0.35;
  s.viscous_tolerance = 1e-5;
  return s;
}

/// Particles on the lattice that fills [from, to], at rest density, each of type of(x, y, z); jitter in spacings.
template <int Dim, class TypeOf>
ParticleSet fill_lattice(const Scene<Dim>& scene, const TypeOf& type_of, double jitter = 0) {
  ParticleSet p;
  const double dp = scene.spacing;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-jitter * dp, jitter * dp);
  Vec<Dim, int> n{};
  for (int k = 0; k < Dim; ++k) n[k] = static_cast<int>(std::lround((scene.domain_to[k] - scene.domain_from[k]) / dp));
  for (int kz = 0; kz < n[Dim - 1]; ++kz) {
    for (int ky = 0; ky < (Dim == 3 ? n[1] : 1); ++ky) {
      for (int kx = 0; kx < n[0]; ++kx) {
        const Vec3 node(scene.domain_from[0] + (kx + 0.5) * dp, Dim == 3 ? (ky + 0.5) * dp : 0,
                        scene.domain_from[Dim - 1] + (kz + 0.5) * dp);
        const ParticleType type = type_of(node);
        const bool solid = type == ParticleType::wall;
        p.id.push_back(static_cast<std::int64_t>(p.id.size()));
        p.type.push_back(type);
        p.position.push_back(solid ? node
                                   : Vec3(node + Vec3(shift(random), Dim == 3 ? shift(random) : 0, shift(random))));
        const float rho = type == ParticleType::sediment ? scene.sediment_density : scene.water_density;
        p.density.push_back(rho);
        p.mass.push_back(rho * static_cast<float>(std::pow(dp, Dim)));
        p.velocity.push_back(Eigen::Vector3f::Zero());
        p.pressure.push_back(0);
      }
    }
  }
  return p;
}

inline ParticleType all_water(const Vec3&) { return ParticleType::water; }

}  // namespace thalweg::test
