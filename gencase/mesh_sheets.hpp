#pragma once

#include <cstddef>
#include <vector>

#include "gencase/region.hpp"

namespace thalweg::gencase {

/// An edge and the faces that use it.
struct EdgeFaces {
  std::uint32_t low = 0, high = 0;  // its points, by number
  struct Use {
    std::uint32_t face;
    bool forth;  // the face runs from low to high
  };
  std::vector<Use> uses;
};

/// Every edge of a surface once, in the order of its points' numbers. Faces that use a point twice add no edge for it.
std::vector<EdgeFaces> edges_with_faces(const Triangles& surface);

/// Takes away pairs of faces that have the same corners and look opposite ways, as two boxes with a common face have
/// them. A pair stays where an edge would be left without balance. Returns the number of faces taken away.
std::size_t cancel_back_to_back(Triangles& surface);

/// Gives every sheet points of its own where several sheets meet in an edge or a corner. Where as many faces use an
/// edge in one direction as in the other, two faces with the body between them belong together; elsewhere nothing is
/// parted, and find_defects() finds the edge.
void part_sheets(Triangles& surface);

/// The sheets of a surface: its connected parts, parted along edges of more than two faces too.
std::vector<Triangles> sheets_of(const Triangles& surface);

/// Turns faces so that neighbours look the same way; of each connected part, the smaller number of faces turns.
/// Returns the number turned.
std::size_t turn_alike(Triangles& surface);

}  // namespace thalweg::gencase
