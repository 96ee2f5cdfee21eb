#pragma once

#include <memory>

#include "case/case.hpp"
#include "solver/models/openings/openings.hpp"

namespace thalweg {

/// The openings of a case; null if it has none.
std::shared_ptr<Openings> make_openings(const Case& of);

}  // namespace thalweg
