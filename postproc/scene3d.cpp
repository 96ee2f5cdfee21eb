#include "postproc/scene3d.hpp"

#include <vtkCellArray.h>
#include <vtkContourFilter.h>
#include <vtkDataArray.h>
#include <vtkDecimatePro.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTriangleFilter.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>

#include "common/error.hpp"
#include "common/extraction/parts.hpp"
#include "common/io/particle_file.hpp"
#include "common/io/poly_data_file.hpp"
#include "common/io/series.hpp"
#include "postproc/embedded.hpp"
#include "postproc/html.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

// The most triangles of one surface: with more, a page with twenty times would exceed some megabytes.
constexpr vtkIdType most_triangles = 20'000;

template <class T>
std::string base64_of(const std::vector<T>& numbers) {
  return html::base64({reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T)});
}

// Triangles, and no more of them than the page can hold.
vtkSmartPointer<vtkPolyData> triangles_of(vtkPolyData* surface, SpaceScene& scene) {
  const vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(surface);
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  vtkSmartPointer<vtkPolyData> result = triangles->GetOutput();
  const vtkIdType count = result->GetNumberOfPolys();
  if (count > most_triangles) {
    const vtkNew<vtkDecimatePro> decimate;
    decimate->SetInputData(result);
    decimate->SetTargetReduction(1 - static_cast<double>(most_triangles) / static_cast<double>(count));
    decimate->PreserveTopologyOff();
    decimate->Update();
    result = decimate->GetOutput();
    scene.thinned = true;
  }
  scene.most_triangles = std::max(scene.most_triangles, static_cast<std::size_t>(result->GetNumberOfPolys()));
  return result;
}

nlohmann::json json_of(vtkPolyData* surface, double& largest) {
  std::vector<float> points;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i) {
    for (const int axis : {0, 1, 2}) points.push_back(static_cast<float>(surface->GetPoint(i)[axis]));
  }
  std::vector<std::uint32_t> corners;
  const vtkNew<vtkIdList> corner_list;
  for (vtkIdType c = 0; c < surface->GetPolys()->GetNumberOfCells(); ++c) {
    surface->GetPolys()->GetCellAtId(c, corner_list);
    for (vtkIdType k = 0; k < 3; ++k) corners.push_back(static_cast<std::uint32_t>(corner_list->GetId(k)));
  }
  nlohmann::json json{{"points", base64_of(points)}, {"triangles", base64_of(corners)}};
  if (vtkDataArray* change = surface->GetPointData()->GetArray("BedLevelChange")) {
    std::vector<float> values;
    for (vtkIdType i = 0; i < change->GetNumberOfTuples(); ++i) {
      const double value = change->GetComponent(i, 0);
      values.push_back(static_cast<float>(value));
      if (!std::isnan(value)) largest = std::max(largest, std::abs(value));
    }
    json["change"] = base64_of(values);
  }
  return json;
}

/// The box of the centres of all particles that count, and a margin around it [m].
template <class Counts>
std::array<Vec3, 2> box_around(const ParticleSet& particles, const Counts& counts, double margin) {
  std::array<Vec3, 2> box{Vec3::Constant(INFINITY), Vec3::Constant(-INFINITY)};
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (!counts(i)) continue;
    box[0] = box[0].cwiseMin(particles.position[i]);
    box[1] = box[1].cwiseMax(particles.position[i]);
  }
  return {box[0] - Vec3::Constant(margin), box[1] + Vec3::Constant(margin)};
}

/// The surface around the lattice points of the wall particles that count, half a spacing outside them and smoothed; null
/// without any, and where a lattice around them would not fit into memory.
template <class Counts>
vtkSmartPointer<vtkPolyData> surface_around(const ParticleSet& particles, const Counts& counts) {
  const double step = particles.info.spacing;
  const auto [low, high] = box_around(particles, counts, step);
  if (!(low.x() < high.x())) return nullptr;
  const Eigen::Array3d steps = ((high - low) / step).array().round() + 1;
  constexpr double most_nodes = 2e7;
  if (steps.prod() > most_nodes) return nullptr;
  const vtkNew<vtkImageData> lattice;
  lattice->SetDimensions(static_cast<int>(steps.x()), static_cast<int>(steps.y()), static_cast<int>(steps.z()));
  lattice->SetOrigin(low.data());
  lattice->SetSpacing(step, step, step);
  lattice->AllocateScalars(VTK_FLOAT, 1);
  auto* const filled = static_cast<float*>(lattice->GetScalarPointer());
  std::fill_n(filled, lattice->GetNumberOfPoints(), 0.F);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (!counts(i)) continue;
    const vtkIdType node =
        lattice->FindPoint(particles.position[i].x(), particles.position[i].y(), particles.position[i].z());
    if (node >= 0) filled[node] = 1;
  }
  const vtkNew<vtkContourFilter> contour;
  contour->SetInputData(lattice);
  contour->SetValue(0, 0.5);
  const vtkNew<vtkWindowedSincPolyDataFilter> smooth;
  smooth->SetInputConnection(contour->GetOutputPort());
  smooth->SetNumberOfIterations(20);
  smooth->SetPassBand(0.1);
  smooth->Update();
  return smooth->GetOutput();
}

/// The walls as surfaces: bodies in the space that the fluid fills at the start, at any height, such as piers; and the
/// container around it.
void add_walls(const ParticleSet& particles, nlohmann::json& data, SpaceScene& scene) {
  const auto [low, high] = box_around(
      particles, [&](std::size_t i) { return is_fluid(particles.type[i]); }, -particles.info.spacing);
  const auto is_body = [&, low = low, high = high](std::size_t i) {
    const Vec3& at = particles.position[i];
    return at.x() > low.x() && at.x() < high.x() && at.y() > low.y() && at.y() < high.y() &&
           at.z() >= low.z() - particles.info.spacing;
  };
  const auto add = [&](const char* name, bool bodies) {
    const vtkSmartPointer<vtkPolyData> surface =
        surface_around(particles, [&](std::size_t i) { return is_wall(particles.type[i]) && is_body(i) == bodies; });
    double ignored = 0;
    if (surface != nullptr) data[name] = json_of(triangles_of(surface, scene), ignored);
  };
  add("bodies", true);
  add("walls", false);
}

void add_surfaces(const fs::path& series, const char* name, std::map<double, nlohmann::json>& frames, double& largest,
                  SpaceScene& scene) {
  if (!fs::exists(series)) return;
  for (const SeriesEntry& entry : read_series(series)) {
    const fs::path file = series.parent_path() / entry.file;
    const vtkSmartPointer<vtkPolyData> surface = triangles_of(read_poly_data(file), scene);
    if (surface->GetNumberOfPolys() == 0) continue;
    frames[entry.time][name] = json_of(surface, largest);
  }
}

}  // namespace

SpaceScene make_space_scene(const ReportInput& input) {
  SpaceScene scene;
  if (input.resolved.info.dimension == 2) {
    scene.why_not = "--3d: this run is two-dimensional; the profiles show all of it";
    return scene;
  }
  if (embedded::scene_script.empty()) {
    scene.why_not =
        "--3d: this program was built without vtk.js, because npm or the network was missing; install npm and build "
        "again";
    return scene;
  }
  const fs::path folder = input.run.surfaces();
  std::map<double, nlohmann::json> frames;
  double largest = 0;
  add_surfaces(folder / "bed.pvd", "bed", frames, largest, scene);
  add_surfaces(folder / "free_surface.pvd", "water", frames, largest, scene);
  if (frames.empty()) {
    scene.why_not = "--3d: there are no surfaces in " + folder.string();
    return scene;
  }
  nlohmann::json list = nlohmann::json::array();
  for (auto& [time, frame] : frames) {
    frame["time"] = time;
    list.push_back(std::move(frame));
  }
  scene.frames = list.size();
  scene.largest = std::max(largest, 1e-3);
  const fs::path start = input.run.particles();
  nlohmann::json data{
      {"spacing", input.extraction.info.spacing}, {"largest", scene.largest}, {"frames", std::move(list)}};
  if (fs::exists(start)) add_walls(read_particles(start), data, scene);
  scene.data = data.dump();
  return scene;
}

}  // namespace thalweg
