#pragma once

#include "physics/host_device.hpp"

namespace thalweg {

/// A vector of the scene's dimension: (x, z) in 2-D, (x, y, z) in 3-D. The last entry is always the vertical one.
/// T is a number or a pack of numbers.
template <int Dim, class T>
struct Vec {
  T c[Dim];

  HOST_DEVICE T& operator[](int k) { return c[k]; }
  HOST_DEVICE const T& operator[](int k) const { return c[k]; }
  HOST_DEVICE T& vertical() { return c[Dim - 1]; }
  HOST_DEVICE const T& vertical() const { return c[Dim - 1]; }

  HOST_DEVICE Vec& operator+=(const Vec& b) {
    for (int k = 0; k < Dim; ++k) c[k] += b.c[k];
    return *this;
  }
};

template <int Dim, class T>
HOST_DEVICE inline Vec<Dim, T> operator+(Vec<Dim, T> a, const Vec<Dim, T>& b) {
  return a += b;
}

template <int Dim, class T>
HOST_DEVICE inline Vec<Dim, T> operator-(const Vec<Dim, T>& a, const Vec<Dim, T>& b) {
  Vec<Dim, T> out{};
  for (int k = 0; k < Dim; ++k) out.c[k] = a.c[k] - b.c[k];
  return out;
}

template <int Dim, class T>
HOST_DEVICE inline Vec<Dim, T> operator*(const T& s, const Vec<Dim, T>& a) {
  Vec<Dim, T> out{};
  for (int k = 0; k < Dim; ++k) out.c[k] = s * a.c[k];
  return out;
}

template <int Dim, class T>
HOST_DEVICE inline T dot(const Vec<Dim, T>& a, const Vec<Dim, T>& b) {
  T sum = a.c[0] * b.c[0];
  for (int k = 1; k < Dim; ++k) sum = sum + a.c[k] * b.c[k];
  return sum;
}

/// Axis of the k-th entry of a Vec<Dim>: 0 for x, 1 for y, 2 for z.
template <int Dim>
HOST_DEVICE constexpr int axis(int k) {
  return (Dim == 2 && k == 1) ? 2 : k;
}

}  // namespace thalweg
