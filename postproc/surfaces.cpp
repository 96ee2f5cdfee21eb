#include "postproc/surfaces.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <vtkCellArray.h>
#include <vtkClipPolyData.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges2D.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkReverseSense.h>
#include <vtkStripper.h>

#include <cmath>
#include <limits>

#include "postproc/surface_values.hpp"

namespace thalweg {
namespace {

constexpr const char* wall_array = "Wall";

// A field as VTK's image. VTK stores images with the first axis fastest, our grids have z fastest: the image's axes are
// z, y, x, or z, x of a plane. Its coordinates count nodes.
class Image {
 public:
  Image(const SurfaceField& field, const ConnectedBody& body) : field_(field) {
    const SamplingGrid& grid = field.sums.grid;
    const auto count = [](std::size_t n) { return static_cast<int>(n); };
    if (is_plane()) {
      data_->SetDimensions(count(grid.nz), count(grid.nx), 1);
    } else {
      data_->SetDimensions(count(grid.nz), count(grid.ny), count(grid.nx));
    }
    vtkNew<vtkFloatArray> values;
    values->SetNumberOfValues(static_cast<vtkIdType>(grid.size()));
    float* to = values->GetPointer(0);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, grid.size()), [&](const auto& range) {
      for (std::size_t node = range.begin(); node < range.end(); ++node) {
        to[node] = body.is_apart(node) ? 0.F : static_cast<float>(body.fraction(node));
      }
    });
    data_->GetPointData()->SetScalars(values);
  }

  [[nodiscard]] vtkSmartPointer<vtkPolyData> contour() const {
    if (is_plane()) {
      vtkNew<vtkFlyingEdges2D> edges;
      edges->SetInputData(data_);
      edges->SetValue(0, 0.5);
      edges->ComputeScalarsOff();
      edges->Update();
      return edges->GetOutput();
    }
    vtkNew<vtkFlyingEdges3D> edges;
    edges->SetInputData(data_);
    edges->SetValue(0, 0.5);
    edges->ComputeScalarsOff();
    edges->ComputeNormalsOn();
    edges->Update();
    return edges->GetOutput();
  }

  /// A number of the nodes, linear between them, at a point of the contour.
  template <class OfNode>
  [[nodiscard]] double sample(const std::array<double, 3>& point, OfNode&& of_node) const {
    const SamplingGrid& grid = field_.sums.grid;
    const std::array<double, 3> place =
        is_plane() ? std::array{point[1], 0.0, point[0]} : std::array{point[2], point[1], point[0]};
    const std::array<std::size_t, 3> count{grid.nx, grid.ny, grid.nz};
    std::array<std::size_t, 3> low{};
    std::array<double, 3> share{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(static_cast<std::size_t>(std::max(0.0, place[axis])), count[axis] - 1);
      share[axis] = place[axis] - static_cast<double>(low[axis]);
    }
    double sum = 0;
    for (unsigned corner = 0; corner < 8; ++corner) {
      double weight = 1;
      std::array<std::size_t, 3> at = low;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const bool upper = ((corner >> axis) & 1U) != 0;
        weight *= upper ? share[axis] : 1 - share[axis];
        if (upper) ++at[axis];
      }
      if (weight > 0) sum += weight * of_node(grid.node(grid.column(at[0], at[1]), at[2]));
    }
    return sum;
  }

  /// From counted nodes to metres.
  [[nodiscard]] Vec3 position(const std::array<double, 3>& point) const {
    const SamplingGrid& grid = field_.sums.grid;
    const auto metres = [&](double nodes, long first) { return (nodes + static_cast<double>(first)) * grid.step; };
    if (is_plane()) return {metres(point[1], grid.first_x), grid.plane_y, metres(point[0], grid.first_z)};
    return {metres(point[2], grid.first_x), metres(point[1], grid.first_y), metres(point[0], grid.first_z)};
  }

  [[nodiscard]] bool is_plane() const { return field_.sums.grid.ny == 1; }

 private:
  const SurfaceField& field_;
  vtkNew<vtkImageData> data_;
};

std::array<double, 3> point_of(vtkPolyData* data, vtkIdType i) {
  std::array<double, 3> point{};
  data->GetPoint(i, point.data());
  return point;
}

// The cells that touch the body. The others are the skin of a floor that is bare of it.
vtkSmartPointer<vtkCellArray> cells_on_body(vtkCellArray* cells, const std::vector<char>& on_body) {
  auto kept = vtkSmartPointer<vtkCellArray>::New();
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  for (cells->InitTraversal(); cells->GetNextCell(count, points) != 0;) {
    const bool touches = std::any_of(points, points + count, [&](vtkIdType p) { return on_body[p] != 0; });
    if (touches) kept->InsertNextCell(count, points);
  }
  return kept;
}

// The part that touches the body and lies outside walls. A point touches it if one of the nodes around it belongs to it.
vtkSmartPointer<vtkPolyData> trimmed(const SurfaceField& field, const ConnectedBody& body, const Image& image,
                                     vtkPolyData* contour) {
  const vtkIdType count = contour->GetNumberOfPoints();
  std::vector<char> touches(static_cast<std::size_t>(count), 0);
  vtkNew<vtkFloatArray> walls;
  walls->SetName(wall_array);
  walls->SetNumberOfValues(count);
  float* wall = walls->GetPointer(0);
  tbb::parallel_for(tbb::blocked_range<vtkIdType>(0, count), [&](const auto& range) {
    for (vtkIdType i = range.begin(); i < range.end(); ++i) {
      const std::array<double, 3> point = point_of(contour, i);
      const double share = image.sample(point, [&](std::size_t node) { return body.belongs(node) ? 1.0 : 0.0; });
      touches[static_cast<std::size_t>(i)] = share > 0 ? 1 : 0;
      wall[i] = static_cast<float>(image.sample(point, [&](std::size_t node) { return field.sums.wall_share(node); }));
    }
  });
  vtkNew<vtkPolyData> wet;
  wet->SetPoints(contour->GetPoints());
  wet->GetPointData()->SetNormals(contour->GetPointData()->GetNormals());
  wet->GetPointData()->SetScalars(walls);
  if (image.is_plane()) {
    wet->SetLines(cells_on_body(contour->GetLines(), touches));
  } else {
    wet->SetPolys(cells_on_body(contour->GetPolys(), touches));
  }
  vtkNew<vtkClipPolyData> clip;
  clip->SetInputData(wet);
  clip->SetValue(VolumeFractions::most_open_share);
  clip->InsideOutOn();
  clip->Update();
  vtkSmartPointer<vtkPolyData> open = clip->GetOutput();
  open->GetPointData()->RemoveArray(wall_array);
  return open;
}

// Joins the segments of lines.
vtkSmartPointer<vtkPolyData> joined(vtkPolyData* pieces) {
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(pieces);
  stripper->SetMaximumLength(std::numeric_limits<int>::max());
  stripper->Update();
  return stripper->GetOutput();
}

// Places points and normals in space. The image's axes are ours in reverse, a reflection, which turns triangles over.
vtkSmartPointer<vtkPolyData> placed(const Image& image, vtkPolyData* counted) {
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(counted->GetNumberOfPoints());
  for (vtkIdType i = 0; i < counted->GetNumberOfPoints(); ++i) {
    const Vec3 at = image.position(point_of(counted, i));
    points->SetPoint(i, at.x(), at.y(), at.z());
  }
  counted->SetPoints(points);
  if (image.is_plane()) return counted;
  if (vtkDataArray* normals = counted->GetPointData()->GetNormals()) {
    for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i) {
      const std::array<double, 3> n{normals->GetComponent(i, 2), normals->GetComponent(i, 1),
                                    normals->GetComponent(i, 0)};
      normals->SetTuple(i, n.data());
    }
  }
  vtkNew<vtkReverseSense> turned;
  turned->SetInputData(counted);
  turned->ReverseCellsOn();
  turned->Update();
  return turned->GetOutput();
}

vtkSmartPointer<vtkPolyData> surface_of(const SurfaceField& field, const ConnectedBody& body) {
  const Image image(field, body);
  vtkSmartPointer<vtkPolyData> open = trimmed(field, body, image, image.contour());
  return placed(image, image.is_plane() ? joined(open) : open);
}

}  // namespace

const char* name_of(SurfaceKind kind) {
  switch (kind) {
    case SurfaceKind::free_surface:
      return "free_surface";
    case SurfaceKind::bed:
      return "bed";
    case SurfaceKind::motionless_bed:
      return "motionless_bed";
  }
  return "";
}

std::vector<Surface> make_surfaces(const ParticleSet& particles, const CellList& cells, const SurfaceField& field,
                                   const LevelMap& initial) {
  std::vector<Surface> surfaces;
  surfaces.push_back({SurfaceKind::free_surface, surface_of(field, field.bodies.fluid)});
  if (field.bodies.sediment) surfaces.push_back({SurfaceKind::bed, surface_of(field, *field.bodies.sediment)});
  if (field.bodies.resting) surfaces.push_back({SurfaceKind::motionless_bed, surface_of(field, *field.bodies.resting)});
  for (const Surface& surface : surfaces) {
    const bool of_bed = surface.kind != SurfaceKind::free_surface;
    add_particle_values(surface.data, particles, cells, of_bed, surface.kind == SurfaceKind::bed);
    if (surface.kind == SurfaceKind::bed) add_bed_change(surface.data, initial, &ColumnLevels::bed);
    if (surface.kind == SurfaceKind::motionless_bed) {
      add_bed_change(surface.data, initial, &ColumnLevels::motionless_bed);
    }
  }
  return surfaces;
}

}  // namespace thalweg
