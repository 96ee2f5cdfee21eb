#pragma once

namespace thalweg {

/// Von Karman's constant kappa [-] of the logarithmic law.
template <class Real>
inline constexpr Real von_karman = Real(0.41);

}  // namespace thalweg
