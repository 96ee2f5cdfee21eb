#include "common/particle_faults.hpp"

#include <fmt/format.h>

namespace thalweg {

std::string fault_of_particle(const std::string& file, std::int64_t id, const Vec3& at, const std::string& what) {
  return fmt::format("{}: particle {} at x = {:.4g} m, z = {:.4g} m: {}; correct it, or fill the scene with gencase",
                     file, id, at.x(), at.z(), what);
}

std::string fault_of_negative_id(const std::string& file, std::int64_t id) {
  return fmt::format("{}: a particle has the id {}; number from 0", file, id);
}

std::string fault_of_two_with_an_id(const std::string& file, std::int64_t id) {
  return fmt::format("{}: two particles have the id {}; give each its own", file, id);
}

std::string fault_of_two_in_a_place(const std::string& file, std::int64_t id, const Vec3& at, std::int64_t other) {
  return fault_of_particle(file, id, at, fmt::format("it lies in the place of particle {}", other));
}

}  // namespace thalweg
