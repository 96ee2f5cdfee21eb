#pragma once

#include "physics/host_device.hpp"

// The top layer of a bed, found by how much of a particle's kernel the bed fills: Sigma V W over the sediment and the
// walls in reach is 1 inside the bed and less at its surface. On a square or cubic lattice of spacing dp, with the
// Wendland kernel (C2) of smoothing length h, 2-D (3-D differs by 0.005 at most):
//
//   h/dp            1.1    1.2    1.3    1.5    1.55   1.6    2.1    3.0
//   top layer       0.86   0.82   0.79   0.75   0.74   0.74   0.68   0.62
//   second layer    1.03   1.02   1.01   0.99   0.98   0.98   0.92   0.83
//
// A threshold has to lie between the two rows. 0.85 does so up to h/dp = 2.7, 0.81 from 1.3 on and up to 3.0. With h/dp
// below 1.2 the top layer of a perfect lattice is not found.
namespace thalweg {

/// Threshold [-] for kernels of up to some 1.5 spacings, about half-way between the two layers at h/dp = 1.5.
inline constexpr float surface_fill_narrow = 0.85F;
/// Threshold [-] for wider kernels, whose layers are less full: about half-way at h/dp = 2.1.
inline constexpr float surface_fill_wide = 0.81F;
/// The source paper's threshold [-] for every kernel: a density of 1250 kg/m^3 in a bed of 1540
/// (sediment_parameters.hpp names the paper).
inline constexpr float surface_fill_as_printed = 0.81F;
/// Three states: by so much more [-] a grain that moves has to be buried before it belongs to the bed again.
inline constexpr float surface_fill_hysteresis = 0.07F;

/// The largest h/dp [-] that takes the threshold for narrow kernels, where the three states look for the surface and
/// where the Laplace pressure does. Between the two, either threshold separates the layers of a lattice; one common
/// limit would change the results of cases that lie there.
inline constexpr double widest_narrow_kernel_of_states = 1.55;
inline constexpr double widest_narrow_kernel_of_laplace = 1.5;

/// Share of the kernel [-] below which a particle is in the bed's top layer. smoothing_length and spacing in the same
/// unit: both in m, or h/dp and 1; widest_narrow_kernel [-] is one of the two limits above.
/// h/dp = 1.5: 0.85; h/dp = 2: 0.81.
HOST_DEVICE constexpr float surface_fill(double smoothing_length, double spacing, double widest_narrow_kernel) {
  return smoothing_length <= widest_narrow_kernel * spacing ? surface_fill_narrow : surface_fill_wide;
}

}  // namespace thalweg
