#include "solver/program/start_check.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "common/error.hpp"
#include "common/particle_faults.hpp"
#include "common/units.hpp"
#include "solver/simulation/start.hpp"

namespace thalweg {
namespace {

/// Rejects a file in one way of speaking.
class Checker {
 public:
  Checker(const ParticleSet& particles, const std::filesystem::path& file) : p_(particles), file_(file) {}

  void facts(const Case& scene) const {
    const ParticleFileInfo& info = p_.info;
    if (info.dimension != scene.info.dimension) {
      reject(fmt::format("made for {} dimensions, the case has {}", info.dimension, scene.info.dimension), refill);
    }
    if (!(info.spacing > 0)) {
      reject("the fact Spacing is missing in the field data, or is no length",
             fmt::format("write Spacing = {:g} [m] into the field data, or fill the scene with gencase",
                         scene.numerics.spacing));
    }
    if (!(std::abs(info.spacing - scene.numerics.spacing) <= 1e-9 * scene.numerics.spacing)) {
      reject(fmt::format("filled with a spacing of {}, the case says {}", format_quantity(info.spacing, "m"),
                         format_quantity(scene.numerics.spacing, "m")),
             refill);
    }
    if (!(info.time >= 0) || !std::isfinite(info.time) || info.step < 0) {
      reject(fmt::format("its time is {} s and its step {}; both count from 0", info.time, info.step), refill);
    }
    if (info.time > 0 && info.step == 0) reject(fmt::format("at t = {} s no step has been taken", info.time), refill);
  }

  /// The arrays that a start needs.
  void arrays(const Case& scene) const {
    const std::size_t n = p_.size();
    if (n == 0) reject("holds no particles", refill);
    if (p_.density.size() != n || p_.mass.size() != n) {
      reject("arrays Density and Mass are needed to start", "write them, or fill the scene with gencase");
    }
    if (!scene.motions.empty()) motions(scene.motions.size());
  }

  [[nodiscard]] bool has_fluid() const { return std::any_of(p_.type.begin(), p_.type.end(), is_fluid); }

  void require_fluid(const Case& scene, bool has_some) const {
    if (scene.inlets.empty() && !has_some) {
      reject("holds walls only, neither water nor sediment", "give a shape with the role of a fluid");
    }
  }

  void numbers() const {
    for (std::size_t i = 0; i < p_.size(); ++i) {
      if (!p_.velocity.empty() && !p_.velocity[i].allFinite()) reject_particle(i, "its velocity is no number");
      if (!is_fluid(p_.type[i])) continue;
      if (!is_positive(p_.mass[i])) reject_particle(i, fmt::format("its mass is {} kg", p_.mass[i]));
      if (!is_positive(p_.density[i])) reject_particle(i, fmt::format("its density is {} kg/m^3", p_.density[i]));
    }
  }

  void ids() const {
    const auto order = sorted([&](std::size_t a, std::size_t b) { return p_.id[a] < p_.id[b]; });
    const std::int64_t least = p_.id[order.front()];
    if (least < 0) throw InputError(fault_of_negative_id(file_.string(), least));
    const auto twin = std::adjacent_find(order.begin(), order.end(),
                                         [&](std::size_t a, std::size_t b) { return p_.id[a] == p_.id[b]; });
    if (twin != order.end()) throw InputError(fault_of_two_with_an_id(file_.string(), p_.id[*twin]));
  }

  /// A plane scene of so many particles in this box lies in the plane of x and z.
  void plane(const Eigen::AlignedBox3d& box, std::size_t n) const {
    if (!(box.sizes().y() > 0)) return;
    if (n > 1 && box.sizes().z() == 0) {
      reject("all points have one z, and a 2-D scene lies in the plane of x and z", "write heights as z, and y = 0");
    }
    reject("the points of a 2-D scene have several y", "write y = 0 for all of them");
  }

  void extend(Eigen::AlignedBox3d& box) const {
    for (const Vec3& x : p_.position) box.extend(x);
  }

  /// Two particles in one place have no direction between them, and push nothing apart. In a mixture grains and pore
  /// water share places.
  void places(bool mixed) const {
    const auto less = [&](std::size_t a, std::size_t b) {
      return std::lexicographical_compare(p_.position[a].begin(), p_.position[a].end(), p_.position[b].begin(),
                                          p_.position[b].end());
    };
    const auto order = sorted(less);
    for (std::size_t i = 1; i < order.size(); ++i) {
      if (p_.position[order[i]] != p_.position[order[i - 1]]) continue;
      const ParticleType type = p_.type[order[i]];
      const ParticleType other = p_.type[order[i - 1]];
      if (!is_fluid(type) && !is_fluid(other)) continue;
      if (mixed && type != other) continue;
      throw InputError(
          fault_of_two_in_a_place(file_.string(), p_.id[order[i]], p_.position[order[i]], p_.id[order[i - 1]]));
    }
  }

 private:
  static constexpr const char* refill = "fill the scene again with gencase";

  static bool is_fluid(ParticleType type) { return type == ParticleType::water || type == ParticleType::sediment; }
  static bool is_positive(float number) { return number > 0 && std::isfinite(number); }

  [[noreturn]] void reject(const std::string& what, const std::string& cure) const {
    throw InputError(fmt::format("{}: {}; {}", file_.string(), what, cure));
  }
  [[noreturn]] void reject_particle(std::size_t i, const std::string& what) const {
    throw InputError(fault_of_particle(file_.string(), p_.id[i], p_.position[i], what));
  }

  template <class Less>
  [[nodiscard]] std::vector<std::size_t> sorted(const Less& less) const {
    std::vector<std::size_t> order(p_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), less);
    return order;
  }

  void motions(std::size_t known) const {
    const auto found = p_.scalars.find(motion_array);
    if (found == p_.scalars.end() || found->second.size() != p_.size()) {
      reject("the array Motion is needed where walls move", refill);
    }
    for (const float number : found->second) {
      if (number >= 0 && number <= static_cast<float>(known) && std::floor(number) == number) continue;
      reject(fmt::format("the array Motion holds {}, and the case has {} motions", number, known), refill);
    }
  }

  const ParticleSet& p_;
  const std::filesystem::path& file_;
};

}  // namespace

void check_start(const ParticleSet& particles, const std::filesystem::path& file, const Case& scene) {
  const Checker check(particles, file);
  check.facts(scene);
  check.arrays(scene);
  check.require_fluid(scene, check.has_fluid());
  check.numbers();
  check.ids();
  Eigen::AlignedBox3d box;
  check.extend(box);
  if (scene.info.dimension == 2) check.plane(box, particles.size());
  check.places(scene.model.seepage == SeepageModel::mixture);
}

double check_start(ParticleSource& particles, const std::filesystem::path& file, const Case& scene) {
  const Checker all(particles.frame(), file);
  all.facts(scene);
  Eigen::AlignedBox3d box;
  bool has_fluid = false;
  double wall_speed = 0;
  for (std::uint64_t from = 0; from < particles.size(); from += particles_at_once) {
    const ParticleSet range = particles.range(from, std::min(particles.size(), from + particles_at_once));
    const Checker check(range, file);
    check.arrays(scene);
    check.numbers();
    check.extend(box);
    has_fluid = has_fluid || check.has_fluid();
    if (!scene.motions.empty()) wall_speed = std::max(wall_speed, largest_wall_speed(scene, range));
  }
  all.require_fluid(scene, has_fluid);
  if (scene.info.dimension == 2) all.plane(box, particles.size());
  return wall_speed;
}

}  // namespace thalweg
