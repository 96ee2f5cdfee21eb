#pragma once

#include <functional>
#include <string>

#include "gencase/filling.hpp"

namespace thalweg::gencase {

/// Refuses scenes whose filling shows a mistake: a shape without particles (the message says why it has none),
/// particles outside the domain, fluid outside every container. Throws InputError naming shape, line, cause and cure.
void check_filling(const Case& scene, const std::vector<PlacedShape>& shapes, const FlowRoom& room,
                   const Filling& filling);

/// Warns of what is allowed but may be a mistake: fluid that walls keep out, an "empty" shape that clears nothing,
/// walls thinner than the kernel's support. Calls `warn` with one line for each.
void warn_of_filling(const Case& scene, const std::vector<PlacedShape>& shapes, const Filling& filling,
                     const std::function<void(const std::string&)>& warn);

}  // namespace thalweg::gencase
