#pragma once

#include <functional>
#include <string>

#include "gencase/shapes.hpp"

namespace thalweg::gencase {

/// Warns of surveys of walls and beds that do not reach over the whole floor of the containers (without containers, of
/// the domain): how much of it they cover and where they end. Calls `warn` with one line for each.
void warn_of_coverage(const Case& scene, const std::vector<PlacedShape>& shapes,
                      const std::function<void(const std::string&)>& warn);

/// Refuses a container given by a mesh whose inside is the material of a tank's wall: where the mesh was drawn with an
/// outer and an inner skin, water would fill the wall and leave the tank empty. Throws InputError.
void check_container(const Case& scene, const Shape& shape, const Region& body);

}  // namespace thalweg::gencase
