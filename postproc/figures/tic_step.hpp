#pragma once

#include <cmath>
#include <initializer_list>

namespace thalweg {

/// A step of 1, 2 or 5 times a power of ten that divides a length into at most `parts`.
inline double tic_step(double length, int parts) {
  const double least = length / parts;
  const double decade = std::pow(10, std::floor(std::log10(least)));
  for (const double multiple : {1.0, 2.0, 5.0}) {
    if (multiple * decade >= least) return multiple * decade;
  }
  return 10 * decade;
}

}  // namespace thalweg
