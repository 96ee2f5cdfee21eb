#include "common/memory.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cmath>

namespace thalweg {

MemoryEstimate estimate_memory(double particles, int dimension) {
  // Measured: 475 bytes a particle in the plane, 990 in space (bench/results), more the smaller the share of walls.
  const double solver = dimension == 2 ? 500 : 1100;
  constexpr double host = 120;
  return {particles * solver, particles * host};
}

double machine_memory() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

std::string format_bytes(double bytes) {
  constexpr std::array units{"B", "kB", "MB", "GB", "TB", "PB", "EB"};
  std::size_t unit = 0;
  for (; bytes >= 1000 && unit + 1 < units.size(); ++unit) bytes /= 1000;
  return fmt::format("{:.3g} {}", bytes, units[unit]);
}

double spacing_that_fits(double spacing, double needed, double available, int dimension) {
  const double exact = spacing * std::pow(needed / available, 1.0 / dimension);
  const double digit = std::pow(10, std::floor(std::log10(exact)) - 1);
  return std::ceil(exact / digit * (1 - 1e-12)) * digit;
}

}  // namespace thalweg
