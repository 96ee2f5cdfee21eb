#pragma once

#include <cmath>

#include "solver/backend/device.hpp"
#include "solver/models/surface_bed/arrays.hpp"
#include "solver/models/surface_bed/surface_bed.hpp"
#include "solver/state/particles.hpp"
#include "solver/state/scene.hpp"
#include "solver/state/step_state.hpp"

namespace thalweg {

inline constexpr std::uint8_t wall_type_in_files = 0;      // ParticleType::wall
inline constexpr std::uint8_t sediment_type_in_files = 3;  // ParticleType::sediment

/// Particle pass over the walls: rows of the bed stand below the level of their column. The upper ones, which water may
/// feel, lie a spacing apart; the others share what is left evenly. A row that would lie in the ground has no volume and
/// counts as a wall in files, with a millionth of its mass: readers ask for some, and the ground's surface is not raised.
template <int Dim>
struct MoveBedPass {
  using reads = Reads<field::bed_place>;
  using writes = Writes<field::place, field::flow, field::position, field::mass, field::type>;

  Record* records;
  Position* positions;
  float* mass;
  std::uint8_t* type;
  const BedPlace* places;
  const BedColumn* columns;
  double share;  // of the motion [-]
  double rate;   // its change with time [1/s]
  Scene<Dim> scene;
  float volume;  // of a wall particle [m^dim]
  Index first;   // wall particle

  HOST_DEVICE void operator()(Index n) const {
    const Index i = first + n;
    const BedPlace& place = places[i];
    if (!place.is_bed()) return;
    const BedColumn& column = columns[static_cast<Index>(place.column)];
    const double way = double(column.to) - double(column.from);
    const double level = double(column.from) + share * way;
    const double thickness = level - double(column.floor);
    const int row = static_cast<int>(place.row);
    const int near = scene.surface_bed.rows_in_reach;
    const double deeper = double(column.rows) - near;
    double distance = scene.spacing;  // between deep rows
    double depth = (row + 0.5) * scene.spacing;
    if (row >= near && deeper > 0 && thickness > double(column.rows) * scene.spacing) {
      distance = (thickness - near * scene.spacing) / deeper;
      depth = near * scene.spacing + (row - near + 0.5) * distance;
    }
    const bool is_there = depth < thickness + 0.01 * scene.spacing;
    const double z = is_there ? level - depth : double(column.floor) - 0.5 * scene.spacing;
    Record& r = records[i];
    constexpr int up = axis<Dim>(Dim - 1);
    positions[i].x[up] = z;
    r.place[up] = scene.lattice.place(Dim - 1, z);
    r.volume = is_there ? volume : 0;
    for (float& c : r.velocity) c = 0;
    r.velocity[up] = is_there ? static_cast<float>(rate * way) : 0;
    mass[i] = scene.surface_bed.density * volume * (is_there ? static_cast<float>(distance / scene.spacing) : 1e-6F);
    type[i] = is_there ? sediment_type_in_files : wall_type_in_files;
  }
};

/// Particle pass over what a checkpoint holds: rows in the ground, which files call walls, have no volume.
struct BuriedRowsPass {
  using reads = Reads<field::bed_place, field::type>;
  using writes = Writes<field::place>;

  Record* records;
  const std::uint8_t* type;
  const BedPlace* places;

  HOST_DEVICE void operator()(Index i) const {
    if (places[i].is_bed() && type[i] == wall_type_in_files) records[i].volume = 0;
  }
};

/// Particle pass over the walls: the surface of each. The bed's top row carries its column's whole surface, the ground
/// carries its own where hardly any bed is left, and of other walls the part above the bed is left.
template <int Dim>
struct BedElementsPass {
  using reads = Reads<field::position, field::bed_place>;
  using writes = Writes<field::wall_element, field::wall_normal, field::bed_shear>;

  const Position* positions;
  const BedPlace* places;
  const BedColumn* columns;
  WallElement* elements;
  WallNormal* normals;  // nullptr: no other walls move
  float* shear;
  Scene<Dim> scene;
  Index first;  // wall particle

  HOST_DEVICE void operator()(Index n) const {
    const Index i = first + n;
    const BedPlace& place = places[i];
    if (place.column < -0.5F) return;
    const BedColumn& column = columns[static_cast<Index>(place.column)];
    const auto dp = static_cast<float>(scene.spacing);
    const bool is_bare = column.to - column.floor < 0.5F * dp;
    shear[i] = place.row > -0.5F && place.row < 0.5F && !is_bare ? column.shear : 0;
    WallElement& element = elements[i];
    if (!place.is_bed()) {
      const auto z = static_cast<float>(positions[i].x[axis<Dim>(Dim - 1)]);
      const float above = (z + 0.5F * dp - column.to) / dp;
      const float open = place.is_floor > 0.5F ? (is_bare ? 1.0F : 0.0F) : above < 0 ? 0 : above < 1 ? above : 1;
      element.area = place.area * open;
      return;
    }
    element = WallElement{};
    const bool is_top = place.row < 0.5F && !is_bare;
    const float sx = column.slope[0];
    const float sy = Dim == 3 ? column.slope[1] : 0;
    const float length = sqrtf(1 + sx * sx + sy * sy);
    element.normal[0] = -sx / length;
    element.normal[1] = -sy / length;
    element.normal[2] = 1 / length;
    element.depth = 0.5F * dp / length;
    element.roughness = scene.surface_bed.roughness;
    float area = length;
    for (int k = 0; k + 1 < Dim; ++k) area *= dp;
    element.area = is_top ? area : 0;
    if (normals == nullptr) return;
    for (int c = 0; c < 3; ++c) normals[i].of[c] = element.normal[c];
  }
};

/// Particle pass over the walls: adds the shear stress of the step to the sum of its column. One particle of a column has
/// a surface: the bed's top row, or the bare ground.
struct SumShearPass {
  using reads = Reads<field::bed_place, field::wall_element, field::wall_shear>;
  using writes = Writes<>;

  const BedPlace* places;
  const WallElement* elements;
  const WallShear* shear;
  ColumnShear* sums;
  const StepState* state;
  Index first;  // wall particle

  HOST_DEVICE void operator()(Index n) const {
    const Index i = first + n;
    const BedPlace& place = places[i];
    if (place.column < -0.5F || !(elements[i].area > 0)) return;
    if (!place.is_bed() && place.is_floor < 0.5F) return;
    ColumnShear& sum = sums[static_cast<Index>(place.column)];
    const double dt = state->step.dt;
    sum.x += double(shear[i].of[0]) * dt;
    sum.y += double(shear[i].of[1]) * dt;
    sum.time += dt;
  }
};

}  // namespace thalweg
