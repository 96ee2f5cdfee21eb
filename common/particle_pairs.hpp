#pragma once

#include <string>
#include <string_view>
#include <type_traits>

#include "common/particle_arrays.hpp"

namespace thalweg {

/// Calls visit(name, array of a, array of b) for all arrays of particles that either set has; those that a lacks are made in it,
/// empty. Positions are "Points".
template <class Visit>
void for_each_pair(ParticleSet& a, const ParticleSet& b, const Visit& visit) {
  for_each_array(a, [&](const char* name, auto& array) {
    for_each_array(b, [&](const char* other, const auto& array_of_b) {
      if constexpr (std::is_same_v<std::remove_cvref_t<decltype(array_of_b)>, std::remove_cvref_t<decltype(array)>>) {
        if (std::string_view(name) == other) visit(std::string(name), array, array_of_b);
      }
    });
  });
  visit(std::string("Points"), a.position, b.position);
  const auto in_maps = [&](auto& of_a, const auto& of_b) {
    for (const auto& [name, array] : of_b) visit(name, of_a[name], array);
    for (auto& [name, array] : of_a) {
      if (!of_b.contains(name)) visit(name, array, std::remove_cvref_t<decltype(array)>());
    }
  };
  in_maps(a.scalars, b.scalars);
  in_maps(a.doubles, b.doubles);
}

}  // namespace thalweg
