#include "postproc/surface_values.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "common/extraction/kernel_mean.hpp"

namespace thalweg {
namespace {

vtkSmartPointer<vtkFloatArray> add_array(vtkPolyData* surface, const char* name, int components) {
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(surface->GetNumberOfPoints());
  surface->GetPointData()->AddArray(array);
  return array;
}

template <class Body>
void for_points(vtkPolyData* surface, Body&& body) {
  tbb::parallel_for(tbb::blocked_range<vtkIdType>(0, surface->GetNumberOfPoints()), [&](const auto& range) {
    for (vtkIdType i = range.begin(); i < range.end(); ++i) {
      std::array<double, 3> point{};
      surface->GetPoint(i, point.data());
      body(i, Vec3(point[0], point[1], point[2]));
    }
  });
}

}  // namespace

void add_particle_values(vtkPolyData* surface, const ParticleSet& particles, const CellList& cells, bool sediment_only,
                         bool shields) {
  const auto numbers = particles.scalars.find("ShieldsNumber");
  const bool has_shields = shields && numbers != particles.scalars.end();
  const KernelWeight weight(particles);
  float* velocity = particles.velocity.empty() ? nullptr : add_array(surface, "Velocity", 3)->GetPointer(0);
  float* shield = has_shields ? add_array(surface, "ShieldsNumber", 1)->GetPointer(0) : nullptr;
  // The weight is 0 beyond the support; the margin is for rounding.
  const double support2 = std::pow(2 * particles.info.smoothing_length, 2) * (1 + 1e-9);
  for_points(surface, [&](vtkIdType i, const Vec3& at) {
    KernelMean<Eigen::Vector3d> mean_velocity(Vec3::Zero());
    KernelMean<double> mean_shields(0);
    cells.around(at, [&](std::size_t b) {
      const bool counts = sediment_only ? particles.type[b] == ParticleType::sediment : is_fluid(particles.type[b]);
      if (!counts || (at - particles.position[b]).squaredNorm() > support2) return;
      const double w = weight(b, at);
      if (velocity != nullptr) mean_velocity.add(w, particles.velocity[b].cast<double>());
      if (has_shields && numbers->second[b] > 0) mean_shields.add(w, double{numbers->second[b]});
    });
    const Eigen::Vector3f u = mean_velocity.value().cast<float>();
    if (velocity != nullptr) std::copy_n(u.data(), 3, velocity + 3 * i);
    if (shield != nullptr) shield[i] = static_cast<float>(mean_shields.value());
  });
}

void add_bed_change(vtkPolyData* surface, const LevelMap& initial, double ColumnLevels::*height) {
  float* change = add_array(surface, "BedLevelChange", 1)->GetPointer(0);
  float* scour = add_array(surface, "ScourDepth", 1)->GetPointer(0);
  float* deposition = add_array(surface, "DepositionDepth", 1)->GetPointer(0);
  for_points(surface, [&](vtkIdType i, const Vec3& at) {
    change[i] = static_cast<float>(at.z() - initial.at(height, at.x(), at.y()));
    scour[i] = std::isnan(change[i]) ? change[i] : std::max(0.F, -change[i]);
    deposition[i] = std::isnan(change[i]) ? change[i] : std::max(0.F, change[i]);
  });
}

}  // namespace thalweg
