#include "common/extraction/periodic_images.hpp"

#include <cstddef>
#include <vector>

#include "common/particle_arrays.hpp"

namespace thalweg {
namespace {

/// A particle, and where its copy stands.
struct Image {
  std::size_t of;
  Vec3 at;  // [m]
};

/// Adds the copies along one axis, of the particles and of the copies along the axes before.
void add_images(std::vector<Image>& images, const ParticleSet& set, const Domain& domain, int axis, double reach) {
  const double period = domain.to[axis] - domain.from[axis];
  const auto add = [&](const Image& near) {
    Image moved = near;
    if (near.at[axis] < domain.from[axis] + reach) {
      moved.at[axis] = near.at[axis] + period;
      images.push_back(moved);
    }
    if (near.at[axis] > domain.to[axis] - reach) {
      moved.at[axis] = near.at[axis] - period;
      images.push_back(moved);
    }
  };
  const std::vector<Image> before = images;
  for (std::size_t i = 0; i < set.size(); ++i) add({i, set.position[i]});
  for (const Image& image : before) add(image);
}

template <class Array>
void append(Array& array, const std::vector<Image>& images, std::size_t n) {
  if (array.empty()) return;
  const std::size_t each = array.size() / n;
  array.reserve(array.size() + each * images.size());
  for (const Image& image : images) {
    for (std::size_t k = 0; k < each; ++k) array.push_back(array[image.of * each + k]);
  }
}

}  // namespace

std::optional<ParticleSet> with_periodic_images(const ParticleSet& set, const Domain& domain, double reach) {
  if (domain.periodic.empty() || set.size() == 0) return std::nullopt;
  std::vector<Image> images;
  for (int axis = 0; axis < 3; ++axis) {
    if (domain.is_periodic(axis)) add_images(images, set, domain, axis, reach);
  }
  ParticleSet all = set;
  for_each_array(all, [&](const char*, auto& array) { append(array, images, set.size()); });
  for (auto& [name, array] : all.scalars) append(array, images, set.size());
  for (auto& [name, array] : all.doubles) append(array, images, set.size());
  for (const Image& image : images) all.position.push_back(image.at);
  return all;
}

}  // namespace thalweg
