#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#include "physics/host_device.hpp"

// The few operations that a pair term may use, for one particle pair at a time (float on a GPU, float or double in
// tests). solver/backend/pack.hpp overloads the same names for several pairs at a time (SIMD), so that a law is written
// once.
namespace thalweg {

HOST_DEVICE inline float lane_max(float a, float b) { return a > b ? a : b; }
HOST_DEVICE inline float lane_min(float a, float b) { return a < b ? a : b; }
HOST_DEVICE inline float lane_select(bool condition, float yes, float no) { return condition ? yes : no; }
HOST_DEVICE inline float lane_reciprocal(float a) { return 1.0F / a; }
HOST_DEVICE inline float lane_sqrt(float a) { return sqrtf(a); }

// Differences of whole numbers that wrap around, and the parts of conditions.
HOST_DEVICE inline std::int32_t lane_difference(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
}
HOST_DEVICE inline float to_float(std::int32_t a) { return static_cast<float>(a); }
HOST_DEVICE inline bool lane_or(bool a, bool b) { return a || b; }
HOST_DEVICE inline bool lane_and_not(bool a, bool b) { return a && !b; }

/// A float >= 0 without its sign and its lower 15 bits, for arrays that cost memory traffic. It keeps the whole range
/// of float, with a relative error of 2^-9.
struct ShortFloat {
  std::uint16_t bits;
};

// Store to and load from an array with one number for each pair: as many numbers as the lane holds.
HOST_DEVICE inline void lane_store(float* to, float a) { *to = a; }
HOST_DEVICE inline void lane_load(const float* from, float& a) { a = *from; }
HOST_DEVICE inline void lane_store(ShortFloat* to, float a) {
  std::uint32_t bits = 0;
  memcpy(&bits, &a, sizeof(bits));
  to->bits = static_cast<std::uint16_t>((bits + 0x4000U) >> 15U);
}
HOST_DEVICE inline void lane_load(const ShortFloat* from, float& a) {
  const std::uint32_t bits = std::uint32_t{from->bits} << 15U;
  memcpy(&a, &bits, sizeof(a));
}

HOST_DEVICE inline double lane_max(double a, double b) { return a > b ? a : b; }
HOST_DEVICE inline double lane_min(double a, double b) { return a < b ? a : b; }
HOST_DEVICE inline double lane_select(bool condition, double yes, double no) { return condition ? yes : no; }
HOST_DEVICE inline double lane_reciprocal(double a) { return 1.0 / a; }
HOST_DEVICE inline double lane_sqrt(double a) { return sqrt(a); }

}  // namespace thalweg
