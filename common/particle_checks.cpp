#include "common/particle_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "common/error.hpp"
#include "common/units.hpp"

namespace thalweg {
namespace {

/// Refusals of one file.
class Start {
 public:
  Start(const ParticleSet& particles, const std::filesystem::path& file) : set_(particles), file_(file.string()) {}

  [[noreturn]] void refuse(const std::string& what,
                           const std::string& cure = "fill the scene again with gencase") const {
    throw InputError(file_ + ": " + what + "; " + cure);
  }

  void check_arrays() const {
    const std::size_t n = set_.size();
    if (n == 0) refuse("holds no particles");
    if (set_.density.size() != n || set_.mass.size() != n)
      refuse("arrays Density and Mass are needed to start", "write them, or fill with gencase");
  }

  void check_facts(int dimension, double spacing) const {
    const ParticleFileInfo& info = set_.info;
    if (info.dimension != dimension)
      refuse(fmt::format("made for {} dimensions, the case has {}", info.dimension, dimension));
    if (!(info.spacing > 0))
      refuse("the fact Spacing is missing in the field data, or is no length",
             fmt::format("write Spacing = {:g} [m] into the field data, or fill the scene with gencase", spacing));
    if (std::abs(info.spacing - spacing) > 1e-9 * spacing)
      refuse(fmt::format("filled with a spacing of {}, the case says {}", format_quantity(info.spacing, "m"),
                         format_quantity(spacing, "m")));
    if (!(info.time >= 0 && std::isfinite(info.time)) || info.step < 0)
      refuse(fmt::format("its time of {} s or its step {} is none", info.time, info.step),
             "write a time and a step from 0 on");
  }

  void check_numbers() const {
    for (std::size_t i = 0; i < set_.size(); ++i) {
      const bool sound =
          set_.density[i] > 0 && std::isfinite(set_.density[i]) && set_.mass[i] > 0 && std::isfinite(set_.mass[i]);
      if (!sound)
        refuse(
            fmt::format("particle {} has the density {} kg/m^3 and the mass {} kg", i, set_.density[i], set_.mass[i]),
            "give finite numbers above zero");
      if (i < set_.velocity.size() && !set_.velocity[i].allFinite())
        refuse(fmt::format("particle {} has a velocity that is not finite", i), "give finite numbers");
    }
  }

  void check_ids() const {
    std::vector<std::int64_t> ids = set_.id;
    std::sort(ids.begin(), ids.end());
    const auto twice = std::adjacent_find(ids.begin(), ids.end());
    if (twice != ids.end()) refuse(fmt::format("two particles have the Id {}", *twice), "number the particles");
    if (!ids.empty() && ids.front() < 0) refuse(fmt::format("a particle has the Id {}", ids.front()), "number from 0");
  }

  void check_plane() const {
    const auto extent = [&](int axis) {
      const auto [low, high] = std::minmax_element(set_.position.begin(), set_.position.end(),
                                                   [&](const Vec3& a, const Vec3& b) { return a[axis] < b[axis]; });
      return (*high)[axis] - (*low)[axis];
    };
    if (set_.size() > 1 && extent(2) == 0 && extent(1) > 0)
      refuse("all points have one z: a 2-D scene lies in the plane of x and z", "write heights as z, and y = 0");
    if (extent(1) > 0) refuse("the points of a 2-D scene have several y", "write y = 0 for all of them");
  }

  void check_fluid() const {
    const auto fluid = [](ParticleType type) { return type == ParticleType::water || type == ParticleType::sediment; };
    if (std::none_of(set_.type.begin(), set_.type.end(), fluid))
      refuse("holds no water and no sediment", "give Type 2 to water and 3 to sediment");
  }

  /// Fluid particles nearer than a thousandth of the spacing stand for the same mass twice. Those of a mixture, water in
  /// the places of grains, do so on purpose.
  void check_places(double spacing) const {
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < set_.size(); ++i)
      if (set_.type[i] != ParticleType::wall && set_.type[i] != ParticleType::moving_wall) order.push_back(i);
    const double near = 1e-3 * spacing;
    const auto cell = [&](std::uint32_t i) {
      const Vec3& p = set_.position[i];
      return std::tuple(set_.type[i], std::floor(p.x() / near), std::floor(p.y() / near), std::floor(p.z() / near));
    };
    std::sort(order.begin(), order.end(), [&](auto i, auto j) { return cell(i) < cell(j); });
    std::size_t pairs = 0;
    std::size_t first = 0;
    for (std::size_t k = 1; k < order.size(); ++k) {
      if (cell(order[k]) != cell(order[k - 1])) continue;
      if (pairs++ == 0) first = k;
    }
    if (pairs == 0) return;
    const Vec3& p = set_.position[order[first]];
    refuse(fmt::format("{} fluid particles stand in the place of another, the first at x = {} m, y = {} m, z = {} m",
                       pairs, p.x(), p.y(), p.z()),
           "write every particle once");
  }

 private:
  const ParticleSet& set_;
  std::string file_;
};

}  // namespace

void check_start(const ParticleSet& particles, const std::filesystem::path& file, int dimension, double spacing) {
  const Start start(particles, file);
  start.check_arrays();
  start.check_facts(dimension, spacing);
  start.check_numbers();
  start.check_ids();
  start.check_fluid();
  if (dimension == 2) start.check_plane();
  start.check_places(spacing);
}

}  // namespace thalweg
