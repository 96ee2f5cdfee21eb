#pragma once

#include <cstdint>
#include <string>

#include "common/particles.hpp"

// Messages for particles that no run can start with, wherever they are found (start_check.hpp, twin_search.hpp).
namespace thalweg {

/// A fault of one particle.
std::string fault_of_particle(const std::string& file, std::int64_t id, const Vec3& at, const std::string& what);

std::string fault_of_negative_id(const std::string& file, std::int64_t id);
std::string fault_of_two_with_an_id(const std::string& file, std::int64_t id);
std::string fault_of_two_in_a_place(const std::string& file, std::int64_t id, const Vec3& at, std::int64_t other);

}  // namespace thalweg
