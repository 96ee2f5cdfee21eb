#include "common/io/surface_file.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolygon.h>

#include "common/io/poly_data_file.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

void append_polygons(vtkCellArray* cells, PolygonSoup& soup) {
  vtkIdType count = 0;
  const vtkIdType* corners = nullptr;
  for (cells->InitTraversal(); cells->GetNextCell(count, corners) != 0;)
    soup.polygons.emplace_back(corners, corners + count);
}

void append_strips(vtkCellArray* cells, PolygonSoup& soup) {
  vtkIdType count = 0;
  const vtkIdType* corners = nullptr;
  for (cells->InitTraversal(); cells->GetNextCell(count, corners) != 0;)
    for (vtkIdType k = 0; k + 2 < count; ++k) {
      const auto a = static_cast<std::size_t>(corners[k]);
      const auto b = static_cast<std::size_t>(corners[k + 1]);
      const auto c = static_cast<std::size_t>(corners[k + 2]);
      soup.polygons.push_back(k % 2 == 0 ? std::vector{a, b, c} : std::vector{b, a, c});
    }
}

}  // namespace

PolygonSoup read_vtp_surface(const fs::path& file) {
  const vtkSmartPointer<vtkPolyData> data = read_poly_data(file);
  PolygonSoup soup;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    std::array<double, 3> p{};
    data->GetPoint(i, p.data());
    soup.points.emplace_back(p[0], p[1], p[2]);
  }
  append_polygons(data->GetPolys(), soup);
  append_strips(data->GetStrips(), soup);
  return soup;
}

void write_lines(const fs::path& file, const LineSet& lines) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIntArray> numbers;
  numbers->SetName(lines.number_name.c_str());
  for (std::size_t i = 0; i < lines.lines.size(); ++i) {
    cells->InsertNextCell(static_cast<int>(lines.lines[i].size()));
    for (const Vec3& p : lines.lines[i]) cells->InsertCellPoint(points->InsertNextPoint(p.data()));
    numbers->InsertNextValue(lines.numbers[i]);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(cells);
  data->GetCellData()->AddArray(numbers);
  write_poly_data(file, data);
}

}  // namespace thalweg
