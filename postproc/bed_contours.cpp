// Contour lines of a bed's map, by VTK.
#include <vtkCellArray.h>
#include <vtkContourFilter.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStripper.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "postproc/bed_map.hpp"

namespace thalweg {
namespace {

/// The cells whose four corners have values, as quadrangles with the values at their points.
vtkSmartPointer<vtkPolyData> quadrangles_of(const BedMap& map, const std::vector<double>& values) {
  const vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const vtkNew<vtkDoubleArray> scalars;
  for (std::size_t i = 0; i < map.nx; ++i) {
    for (std::size_t j = 0; j < map.ny; ++j) {
      points->InsertNextPoint(map.x(i), map.y(j), 0);
      scalars->InsertNextValue(values[map.index(i, j)]);
    }
  }
  const vtkNew<vtkCellArray> cells;
  for (std::size_t i = 0; i + 1 < map.nx; ++i) {
    for (std::size_t j = 0; j + 1 < map.ny; ++j) {
      const std::array corners{map.index(i, j), map.index(i + 1, j), map.index(i + 1, j + 1), map.index(i, j + 1)};
      if (std::any_of(corners.begin(), corners.end(), [&](std::size_t k) { return std::isnan(values[k]); })) continue;
      cells->InsertNextCell(4);
      for (const std::size_t k : corners) cells->InsertCellPoint(static_cast<vtkIdType>(k));
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetPointData()->SetScalars(scalars);
  return data;
}

}  // namespace

std::vector<double> contour_levels(const std::vector<double>& values, double step) {
  double low = 0;
  double high = 0;
  for (const double value : values) {
    if (std::isnan(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  std::vector<double> levels;
  for (long n = std::lround(std::ceil(low / step)); n <= std::lround(std::floor(high / step)); ++n) {
    if (n != 0) levels.push_back(step * static_cast<double>(n));
  }
  return levels;
}

std::vector<Contour> contours_of(const BedMap& map, const std::vector<double>& values,
                                 const std::vector<double>& levels) {
  std::vector<Contour> contours;
  if (map.ny == 1) return contours;
  const vtkSmartPointer<vtkPolyData> cells = quadrangles_of(map, values);
  for (const double level : levels) {
    const vtkNew<vtkContourFilter> filter;
    filter->SetInputData(cells);
    filter->SetValue(0, level);
    const vtkNew<vtkStripper> lines;
    lines->SetInputConnection(filter->GetOutputPort());
    lines->JoinContiguousSegmentsOn();
    lines->Update();
    vtkPolyData* const found = lines->GetOutput();
    const vtkNew<vtkIdList> ids;
    for (vtkIdType c = 0; c < found->GetNumberOfLines(); ++c) {
      found->GetLines()->GetCellAtId(c, ids);
      Contour contour{level, {}};
      for (vtkIdType n = 0; n < ids->GetNumberOfIds(); ++n) {
        const double* const point = found->GetPoint(ids->GetId(n));
        contour.points.push_back({point[0], point[1]});
      }
      if (contour.points.size() > 1) contours.push_back(std::move(contour));
    }
  }
  return contours;
}

}  // namespace thalweg
