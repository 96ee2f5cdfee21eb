#pragma once

#include "physics/host_device.hpp"
#include "solver/models/wall_stress/arrays.hpp"
#include "solver/state/arrays.hpp"
#include "solver/state/field.hpp"

namespace thalweg {

/// The part of a wall particle in the bed of columns.
struct BedPlace {
  float column = -1;   // its number; -1: the particle has no part in the bed
  float row = -1;      // counted from the bed's surface down; -1: a floor or another wall, which stays
  float area = 0;      // of the wall's surface when no bed covers it [m^(dim-1)]
  float is_floor = 0;  // 1: the ground under its column

  [[nodiscard]] HOST_DEVICE bool is_bed() const { return row > -0.5F; }
};

namespace field {
inline constexpr Field bed_place{"BedPlace"};
inline constexpr Field bed_shear{"BedShear"};
}  // namespace field

/// Arrays of a bed that is a surface.
template <class Device>
struct SurfaceBedArrays {
  typename Device::template Buffer<BedPlace> bed_place;
  typename Device::template Buffer<float> bed_shear;  // [Pa] mean of the last window, of the bed's surface

  template <class Scene, class Visitor>
  void describe(const Scene&, Visitor& v) {
    v.array(field::bed_place, bed_place, sorted | checkpointed, BedPlace{});
    v.array(field::bed_shear, bed_shear, sorted | checkpointed, 0.0F);
    v.shown("BedShear", bed_shear);
  }
};

}  // namespace thalweg
