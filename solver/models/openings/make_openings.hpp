#pragma once

#include <memory>
#include <optional>

#include "case/case.hpp"
#include "solver/models/openings/openings.hpp"

namespace thalweg {

/// The openings of a case; null if it has none. lattice_node [m]: a node of the lattice that the scene was filled on, on
/// whose cells rectangular openings stand; without one they stand where the case says.
std::shared_ptr<Openings> make_openings(const Case& of, const std::optional<Vec3>& lattice_node);

}  // namespace thalweg
