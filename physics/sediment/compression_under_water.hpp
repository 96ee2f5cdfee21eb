#pragma once

#include "physics/host_device.hpp"

// The density of sediment with water in reach. Water that arrives over a dry bed fills the empty half of its top row's
// support, and water that slides past fills and empties it all the time. Taken for compression, the one gave the top row
// of a dry bed 1.4 to 18 kPa under water of 0.3, on which a wave rode 2 spacings above the bed; the other presses and
// frees the grains by its noise. So the sediment's own compression counts, water can undo it but not add to it, and the
// pressure is led to that of the water by a slow exchange.
namespace thalweg {

/// The compression by water that counts, B' [1/s], from the compression `own` by sediment and walls and `by_water`, both
/// sum_b V_b u_ab.grad W [1/s]: none where both have one sign, else so much of by_water as undoes own.
template <class Real>
HOST_DEVICE inline Real compression_by_water(Real own, Real by_water) {
  if (own * by_water >= 0) return 0;
  if (by_water > 0) return by_water < -own ? by_water : -own;
  return by_water > -own ? by_water : -own;
}

/// Share of the above that acts on a grain [-], 0 to 1: all of it on a grain of a bed, none on one that flies alone, which
/// has no compression of its own to be relieved. bed_share = sum of V W over sediment and walls, the grain itself left
/// out [-]: 0 for a lone grain, 0.45 in the top row of a bed with h = 1.5 dp, 0.52 with 2 dp.
template <class Real>
HOST_DEVICE inline Real held_share(Real bed_share) {
  const Real s = (bed_share - Real(0.15)) * 5;
  return s < 0 ? 0 : s > 1 ? 1 : s;
}

/// Share of the above that acts where the pressures of bed and water differ [-]: none within the band of exchange_rate(),
/// all from twice the band on. A bed in balance with its water takes the plain sum, whose work the density pays: without
/// this the exchange, which follows the water's pressure late, pumped the sound of still water over a bed up to 10 % of
/// its pressure in 2 s. difference and band as below [Pa].
template <class Real>
HOST_DEVICE inline Real share_out_of_balance(Real difference, Real band) {
  const Real beyond = (difference < 0 ? -difference : difference) - band;
  return beyond <= 0 ? 0 : beyond >= band ? 1 : beyond / band;
}

/// Share of the water's pressure that a bed takes on in place of its own towards the water [-]: all of it up to a
/// difference of twice the pressure of a spacing of water, none from four times on. Still water over a bed, and currents,
/// differ by less than one; what differs by more is an impact. difference and head = rho_w g dp [Pa].
template <class Real>
HOST_DEVICE inline Real share_of_lent(Real difference, Real head) {
  const Real share = 2 - (difference < 0 ? -difference : difference) / (2 * head);
  return share < 0 ? 0 : share > 1 ? 1 : share;
}

/// Rate of the density excess [1/s] that leads the pressure p of sediment to the pressure P of the water over it,
///   R = 0.1 min(1, 4 S) m/(rho_s c h),   m = P - p without its part within +-band
/// P = sum_w V W [p_w + (rho_w + rho_s)/2 g.r]/S, S = sum_w V W over the water. Halfway between a row of sediment and one
/// of water the weight is that of both, hence the mean density; `band` = |rho_s - rho_w| g dp [Pa] is what a spacing more
/// or less of either makes. difference = P - p [Pa]; water_share S [-]; impedance = rho_s c h [kg/(m s)].
template <class Real>
HOST_DEVICE inline Real exchange_rate(Real difference, Real band, Real water_share, Real impedance) {
  const Real within = difference > band ? band : difference < -band ? -band : difference;
  const Real share = 4 * water_share < 1 ? 4 * water_share : Real(1);
  return Real(0.1) * share * (difference - within) / impedance;
}

}  // namespace thalweg
