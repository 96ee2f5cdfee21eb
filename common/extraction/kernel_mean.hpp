#pragma once

#include <cmath>
#include <utility>

#include "common/extraction/parts.hpp"
#include "physics/kernel.hpp"

namespace thalweg {

/// V_b W(|x - x_b|, h) [-] of single particles: the weight of one particle in the solver's sums.
class KernelWeight {
 public:
  /// `of` must outlive it and say spacing and smoothing length.
  explicit KernelWeight(const ParticleSet& of)
      : particles_(of),
        plane_(of.info.smoothing_length),
        space_(of.info.smoothing_length),
        lattice_volume_(std::pow(of.info.spacing, of.info.dimension)) {}

  double operator()(std::size_t b, const Vec3& at) const {
    const double distance = (at - particles_.position[b]).norm();
    const bool plane = particles_.info.dimension == 2;
    const double w = plane ? plane_.value(plane_.closeness(distance)) : space_.value(space_.closeness(distance));
    return w * volume_of(b);
  }

 private:
  [[nodiscard]] double volume_of(std::size_t b) const {
    const bool known = !particles_.mass.empty() && !particles_.density.empty() && particles_.density[b] > 0 &&
                       is_fluid(particles_.type[b]);
    return known ? double{particles_.mass[b]} / double{particles_.density[b]} : lattice_volume_;
  }

  const ParticleSet& particles_;
  WendlandC2<2, double> plane_;
  WendlandC2<3, double> space_;
  double lattice_volume_;
};

/// Weighted mean of values (Shepard 1968): sum w f / sum w; its zero where nothing was added.
template <class T>
class KernelMean {
 public:
  explicit KernelMean(T zero) : sum_(std::move(zero)) {}
  void add(double weight, const T& value) {
    sum_ += weight * value;
    weight_ += weight;
  }
  [[nodiscard]] T value() const { return weight_ > 0 ? T(sum_ / weight_) : sum_; }
  [[nodiscard]] double weight() const { return weight_; }

 private:
  T sum_;
  double weight_ = 0;
};

}  // namespace thalweg
