#include "common/particle_extremes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

#include "common/error.hpp"
#include "common/particle_pairs.hpp"

namespace thalweg {
namespace {

/// Numbers of the components of an entry.
template <class T>
constexpr std::size_t components_of = 1;
template <>
constexpr std::size_t components_of<Eigen::Vector3f> = 3;
template <>
constexpr std::size_t components_of<Vec3> = 3;

/// The number by which a file gives the range of an array: of several components their squared length.
template <class T>
double range_measure(const T* entry, std::size_t components) {
  if constexpr (std::is_enum_v<T>) {
    return static_cast<double>(static_cast<std::underlying_type_t<T>>(*entry));
  } else if constexpr (components_of<T> > 1) {
    return range_measure(entry->data(), components_of<T>);
  } else {
    if (components == 1) return static_cast<double>(*entry);
    double sum = 0;
    for (std::size_t c = 0; c < components; ++c) sum += static_cast<double>(entry[c]) * static_cast<double>(entry[c]);
    return sum;
  }
}

template <class T>
void widen_array(const std::string& name, std::vector<T>& extremes, bool is_new, const std::vector<T>& array,
                 std::size_t n) {
  if (array.empty() && (is_new || extremes.empty())) return;
  const std::size_t entries = is_new ? array.size() / n : extremes.size() / 2;
  if (array.size() != n * entries || entries == 0) {
    throw RunError("array " + name + " does not fit its range of particles");
  }
  if (is_new) {
    extremes.assign(array.begin(), array.begin() + static_cast<std::ptrdiff_t>(entries));
    extremes.insert(extremes.end(), array.begin(), array.begin() + static_cast<std::ptrdiff_t>(entries));
  }
  double least = range_measure(extremes.data(), entries);
  double most = range_measure(extremes.data() + entries, entries);
  for (std::size_t i = 0; i < n; ++i) {
    const T* entry = array.data() + i * entries;
    const double size = range_measure(entry, entries);
    if (size < least || std::isnan(least)) least = size, std::copy_n(entry, entries, extremes.data());
    if (size > most || std::isnan(most)) most = size, std::copy_n(entry, entries, extremes.data() + entries);
  }
}

}  // namespace

void widen(ParticleSet& extremes, const ParticleSet& range) {
  const std::size_t n = range.size();
  if (n == 0) return;
  const bool is_new = extremes.size() == 0;
  for_each_pair(extremes, range, [&](const std::string& name, auto& array, const auto& of_range) {
    widen_array(name, array, is_new, of_range, n);
  });
}

}  // namespace thalweg
