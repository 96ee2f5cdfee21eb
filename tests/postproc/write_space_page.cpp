// Writes a page with the report's 3-D view of made-up surfaces: write_space_page FOLDER. A wave 0.02 m high travels
// over a bed that sinks on the left and rises on the right, around a pier in a flume; 12 triangles by 6 would be enough, 60 by 20 look like
// something.
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <cmath>
#include <iostream>

#include "common/io/particle_file.hpp"
#include "common/io/series.hpp"
#include "common/whole_file.hpp"
#include "postproc/report_sections.hpp"
#include "postproc/report_style.hpp"

namespace {

namespace fs = std::filesystem;

void write_sheet(const fs::path& file, double (*height)(double x, double t), double t, bool is_bed) {
  const vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(0, 0, 0);
  plane->SetPoint1(1.2, 0, 0);
  plane->SetPoint2(0, 0.3, 0);
  plane->SetResolution(60, 20);
  plane->Update();
  vtkPolyData* sheet = plane->GetOutput();
  sheet->GetPointData()->Initialize();
  const vtkNew<vtkFloatArray> change;
  change->SetName("BedLevelChange");
  for (vtkIdType i = 0; i < sheet->GetNumberOfPoints(); ++i) {
    double at[3];
    sheet->GetPoint(i, at);
    sheet->GetPoints()->SetPoint(i, at[0], at[1], height(at[0], t));
    change->InsertNextValue(static_cast<float>(height(at[0], t) - height(at[0], 0)));
  }
  if (is_bed) sheet->GetPointData()->AddArray(change);
  fs::create_directories(file.parent_path());
  const vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(sheet);
  writer->Write();
}

double bed(double x, double t) { return 0.06 - 0.05 * t * std::cos(5.236 * (x - 0.3)) * (x < 0.6 ? 1 : 0.8); }
double water(double x, double t) { return 0.12 + 0.02 * std::sin(10 * (x - t)); }

/// Water of a lattice of 20 mm in a flume, around a pier: what says where walls and bodies are.
thalweg::ParticleSet start() {
  thalweg::ParticleSet set;
  constexpr double spacing = 0.02;
  set.info.dimension = 3;
  set.info.spacing = spacing;
  for (int i = -1; i <= 60; ++i) {
    for (int j = -1; j <= 15; ++j) {
      for (int k = -1; k <= 9; ++k) {
        const thalweg::Vec3 at(spacing * (i + 0.5), spacing * (j + 0.5), spacing * (k + 0.5));
        const bool container = i < 0 || i > 59 || j < 0 || j > 14 || k < 0;
        const bool pier = std::hypot(at.x() - 0.6, at.y() - 0.15) < 0.05;
        if (!container && !pier && k > 5) continue;  // air
        set.id.push_back(static_cast<std::int64_t>(set.size()));
        set.type.push_back(container || pier ? thalweg::ParticleType::wall : thalweg::ParticleType::water);
        set.position.push_back(at);
      }
    }
  }
  return set;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "error: write_space_page: wrong number of arguments; give a folder\n";
    return 2;
  }
  thalweg::ReportInput input;
  input.run = thalweg::RunFolder{argv[1]};
  input.resolved.info.dimension = 3;
  input.extraction.info.spacing = 0.02;
  fs::remove_all(input.run.root);
  const fs::path surfaces = input.run.root / "surfaces";
  std::vector<thalweg::SeriesEntry> beds;
  std::vector<thalweg::SeriesEntry> waters;
  for (const double t : {0.0, 0.25, 0.5}) {
    beds.push_back({t, "bed_t" + std::to_string(t) + ".vtp"});
    waters.push_back({t, "free_surface_t" + std::to_string(t) + ".vtp"});
    write_sheet(surfaces / beds.back().file, bed, t, true);
    write_sheet(surfaces / waters.back().file, water, t, false);
  }
  thalweg::write_series(surfaces / "bed.pvd", beds);
  thalweg::write_series(surfaces / "free_surface.pvd", waters);
  thalweg::write_particles(input.run.particles(), start(), thalweg::PositionPrecision::double_precision);
  const thalweg::SpaceScene scene = thalweg::make_space_scene(input);
  if (!scene.why_not.empty()) {
    std::cout << scene.why_not << '\n';
    return 77;  // skipped: built without vtk.js
  }
  thalweg::write_whole_text(input.run.root / "index.html", [&](std::ostream& page) {
    page << "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><style>" << thalweg::report_style
         << "</style></head><body>" << thalweg::report_sections::space_view(input, scene) << "</body></html>\n";
  });
  return 0;
}
