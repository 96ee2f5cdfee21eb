#pragma once

#include "solver/passes/sweep.hpp"

namespace thalweg {

/// Pair sweep over fluid near walls, after that of the density's rate: takes off what the fluid around gives a film too
/// much (physics/water/thin_film.hpp).
template <int Dim>
struct FilmRateSweep {
  using neighbours = Neighbours<field::place, field::flow, field::matter>;
  using reads = Reads<field::place, field::flow, field::matter, field::rates>;
  using writes = Writes<field::rates>;
  static constexpr unsigned kernel = kernel_value | kernel_gradient;
  template <class L>
  struct Sum {
    L walls;           // of V W
    Vec<Dim, L> wall;  // of V F r over walls
    Vec<Dim, L> side;  // of V F r over fluid
    L around;          // of V F r^2 over fluid
    L compression;     // of V F u.r over fluid
  };

  const Record* records;
  Rates* rates;
  Scene<Dim> scene;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    const L weight = b.volume * g.F;
    const L of_wall = lane_select(is_wall(b), weight, L(0.0F));
    const L of_fluid = weight - of_wall;
    sum.walls += lane_select(is_wall(b), b.volume * g.W, L(0.0F));
    sum.around += of_fluid * g.r2;
    sum.compression += of_fluid * dot(a.velocity - b.velocity, g.r);
    for (int k = 0; k < Dim; ++k) {
      sum.wall[k] += of_wall * g.r[k];
      sum.side[k] += of_fluid * g.r[k];
    }
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    const Record& r = records[i];
    const float square = dot(sum.wall, sum.wall);
    if (!is_water(r) || !(square > 0)) return;
    const float inside = -dot(sum.side, sum.wall) / square;
    const float excess = scene.thin_film.excess(sum.walls, -sum.around / (Dim - 1), inside);
    rates[i].excess_rate -= excess * (1 + r.excess) * sum.compression;
  }
};

template <int Dim, class Device>
void correct_films(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  sweep(on, p, scene, p.near_walls(), FilmRateSweep<Dim>{p.record.data(), p.rates.data(), scene});
}

}  // namespace thalweg
