#pragma once

#include <string>
#include <vector>

#include "gencase/region.hpp"

namespace thalweg::gencase {

/// A closed surface whose bodies have been judged.
struct Judged {
  Triangles surface;
  std::vector<std::string> changes;  // one clause for each kind of change; empty if nothing was changed
};

/// Takes a closed surface apart into connected bodies and sees to it that each of them counts: a body that is inside
/// out is turned, with all that lies in it; one that lies wholly inside another, looks outward too and so adds nothing
/// is dropped. A body in another that looks inward is a cavity and stays. Bodies must not share points.
Judged judge_bodies(const Triangles& surface);

/// The connected bodies of a surface, as they look there, each with its own points.
std::vector<Triangles> bodies_of(const Triangles& surface);

/// The number of the connected part that each face belongs to, counted from 0 in the order of the faces.
std::vector<std::uint32_t> parts_of(const Triangles& surface);

}  // namespace thalweg::gencase
