#pragma once

#include <array>

#include "case/tables/table.hpp"
#include "common/particles.hpp"

namespace thalweg {

enum class LatticeAnchor { walls, domain, point };

inline constexpr std::array<Choice<LatticeAnchor>, 3> choices(LatticeAnchor) {
  return {
      {{LatticeAnchor::walls, "walls",
        "the lower corner of the first container, so that flat walls stand half a spacing from the first particles; "
        "the domain's without a container"},
       {LatticeAnchor::domain, "domain", "the lower corner of the domain"},
       {LatticeAnchor::point, "point", "`anchor_point`"}}};
}

/// [gencase]: how shapes become particles.
struct GencaseParameters {
  static constexpr TableHeading heading{"gencase", "How shapes become particles."};

  LatticeAnchor anchor = LatticeAnchor::walls;
  Vec3 anchor_point = Vec3::Zero();  // [m]
  int relaxation = 0;

  template <class V>
  void describe(V& v) {
    v.choice("anchor", anchor,
             "What the lattice of particles is aligned with: particles stand half a spacing from it.");
    v.point("anchor_point", anchor_point, "m", "anchor = \"point\": a corner of the lattice's cells.");
    v.integer(
        "relaxation", relaxation, 0, 1000,
        "Largest number of sweeps that fit fluid to curved walls: half a spacing from them, and evenly; 0: leave the "
        "lattice.");
  }
};

}  // namespace thalweg
