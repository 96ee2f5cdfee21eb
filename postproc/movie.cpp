#include "postproc/movie.hpp"

#include <fmt/format.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkFloatArray.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkPointGaussianMapper.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "common/error.hpp"
#include "common/extraction/parts.hpp"
#include "common/io/particle_file.hpp"
#include "common/process.hpp"
#include "common/whole_file.hpp"
#include "postproc/display.hpp"
#include "postproc/snapshots.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;
using Colour = std::array<double, 3>;

// As in view/view.py: water from light to dark, sediment from dark to light, so that they differ where both are fast.
constexpr std::array<Colour, 4> blues{{{0.78, 0.86, 0.94}, {0.62, 0.79, 0.88}, {0.19, 0.51, 0.74}, {0.03, 0.19, 0.42}}};
constexpr std::array<Colour, 3> browns{{{0.40, 0.29, 0.17}, {0.80, 0.52, 0.20}, {1.0, 0.85, 0.45}}};
constexpr std::array<Colour, 4> states{
    {{0.71, 0.58, 0.42}, {0.71, 0.58, 0.42}, {0.90, 0.62, 0.00}, {0.84, 0.37, 0.00}}};
constexpr Colour grey{0.72, 0.72, 0.72};

template <std::size_t n>
Colour blend(const std::array<Colour, n>& colours, double share) {
  const double place = std::clamp(share, 0.0, 1.0) * (n - 1);
  const auto k = std::min(static_cast<std::size_t>(place), n - 2);
  Colour mixed{};
  for (std::size_t c = 0; c < 3; ++c)
    mixed[c] = std::lerp(colours[k][c], colours[k + 1][c], place - static_cast<double>(k));
  return mixed;
}

struct Room {
  Vec3 low = Vec3::Constant(INFINITY);
  Vec3 high = Vec3::Constant(-INFINITY);
  double fastest = 0;  // [m/s] all but a hundredth of the water is slower

  void add(const ParticleSet& particles) {
    std::vector<float> speeds;
    for (std::size_t i = 0; i < particles.size(); ++i) {
      if (!is_fluid(particles.type[i])) continue;
      low = low.cwiseMin(particles.position[i]);
      high = high.cwiseMax(particles.position[i]);
      if (particles.type[i] == ParticleType::water && !particles.velocity.empty()) {
        speeds.push_back(particles.velocity[i].norm());
      }
    }
    if (speeds.empty()) return;
    const auto nth = speeds.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(speeds.size() - 1));
    std::nth_element(speeds.begin(), nth, speeds.end());
    fastest = std::max(fastest, static_cast<double>(*nth));
  }
};

// The fluid and some of the walls: in 2-D those that enclose the flow, in 3-D those that stand in it.
vtkSmartPointer<vtkPolyData> coloured(const ParticleSet& particles, const Room& room, bool by_state) {
  const bool flat = particles.info.dimension == 2;
  const double margin = (flat ? 3 : -1) * particles.info.spacing;
  const vtkNew<vtkPoints> points;
  const vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  colours->SetName("Colour");
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Vec3& at = particles.position[i];
    const double speed = particles.velocity.empty() ? 0 : particles.velocity[i].norm();
    const double share = room.fastest > 0 ? speed / room.fastest : 0;
    Colour colour = grey;
    if (particles.type[i] == ParticleType::water) {
      colour = blend(blues, share);
    } else if (particles.type[i] == ParticleType::sediment) {
      colour = by_state ? states[std::min<std::size_t>(static_cast<std::size_t>(particles.state[i]), 3)]
                        : blend(browns, share);
    } else {
      const bool beside = at.x() > room.low.x() - margin && at.x() < room.high.x() + margin &&
                          (flat || (at.y() > room.low.y() - margin && at.y() < room.high.y() + margin));
      const bool below_rim = flat ? at.z() < room.high.z() + margin : at.z() >= room.low.z();
      if (!beside || !below_rim) continue;
    }
    points->InsertNextPoint(at.x(), at.y(), at.z());
    colours->InsertNextTuple3(255 * colour[0], 255 * colour[1], 255 * colour[2]);
  }
  vtkSmartPointer<vtkPolyData> data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->SetScalars(colours);
  return data;
}

// One window for all frames.
class Stage {
 public:
  Stage(const Room& room, const ParticleFileInfo& info, const std::string& title, bool by_state)
      : flat_(info.dimension == 2) {
    mapper_->SetScaleFactor((flat_ ? 0.72 : 0.6) * info.spacing);
    mapper_->EmissiveOff();
    // A disc in the plane; in space it darkens towards its rim and so looks like a ball.
    mapper_->SetSplatShaderCode(
        flat_ ? "//VTK::Color::Impl\nif (dot(offsetVCVSOutput.xy, offsetVCVSOutput.xy) > 1.0) discard;\n"
              : "//VTK::Color::Impl\nfloat rim = dot(offsetVCVSOutput.xy, offsetVCVSOutput.xy);\n"
                "if (rim > 1.0) discard;\nambientColor *= 1.0 - 0.7 * rim;\ndiffuseColor *= 1.0 - 0.7 * rim;\n");
    const vtkNew<vtkActor> actor;
    actor->SetMapper(mapper_);
    actor->GetProperty()->SetAmbient(flat_ ? 1 : 0.2);
    actor->GetProperty()->SetDiffuse(flat_ ? 0 : 0.8);
    renderer_->AddActor(actor);
    renderer_->SetBackground(1, 1, 1);
    window_->OffScreenRenderingOn();
    window_->SetMultiSamples(4);
    window_->AddRenderer(renderer_);
    aim(room, info.spacing);
    const int top = height_ - 36;
    add_text(clock_, 1560, top, true);
    const vtkNew<vtkTextActor> name;
    name->SetInput(title.c_str());
    add_text(name, 40, top, false);
    const vtkNew<vtkTextActor> sediment;
    sediment->SetInput(by_state ? "sediment: brown deposit, orange bed load, red suspended"
                                : "sediment: the lighter, the faster, on the same scale");
    add_text(sediment, 1560, 20, true);
    sediment->GetTextProperty()->SetFontSize(18);
    add_legend(room.fastest);
  }

  void draw(vtkPolyData* particles, double time, const fs::path& file) {
    mapper_->SetInputData(particles);
    clock_->SetInput(fmt::format("t = {:.3f} s", time).c_str());
    window_->Render();
    const vtkNew<vtkWindowToImageFilter> grab;
    grab->SetInput(window_);
    grab->ReadFrontBufferOff();
    const vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(grab->GetOutputPort());
    writer->WriteToMemoryOn();
    writer->Write();
    vtkUnsignedCharArray* picture = writer->GetResult();
    const auto size = static_cast<std::size_t>(picture->GetNumberOfValues());
    write_whole_bytes(file, {reinterpret_cast<const char*>(picture->GetPointer(0)), size});
  }

 private:
  void aim(const Room& room, double spacing) {
    const Vec3 size = room.high - room.low;
    Vec3 middle = (room.low + room.high) / 2;
    vtkCamera* camera = renderer_->GetActiveCamera();
    camera->SetViewUp(0, 0, 1);
    if (flat_) {
      constexpr int above = 50;   // [pixels] for the title
      constexpr int below = 120;  // for the legend
      const double metres = std::max((size.x() + 6 * spacing) / 1560, (size.z() + 6 * spacing) / 640);  // in a pixel
      // Even numbers of pixels, as films want them.
      height_ = (static_cast<int>((size.z() + 6 * spacing) / metres) + above + below) / 2 * 2;
      camera->ParallelProjectionOn();
      camera->SetParallelScale(metres * height_ / 2);
      middle.z() -= (below - above) / 2.0 * metres;
      camera->SetPosition(middle.x(), middle.y() - 10 * size.x(), middle.z());
    } else {
      middle.z() -= 0.06 * size.x();
      camera->SetPosition(middle.x() + 0.25 * size.x(), middle.y() - 0.97 * size.x(), middle.z() + 0.68 * size.x());
    }
    camera->SetFocalPoint(middle.x(), middle.y(), middle.z());
    window_->SetSize(1600, height_);
    renderer_->ResetCameraClippingRange(room.low.x() - size.x(), room.high.x() + size.x(), room.low.y() - size.x(),
                                        room.high.y() + size.x(), room.low.z() - size.x(), room.high.z() + size.x());
  }
  void add_text(vtkTextActor* text, int x, int y, bool right) {
    text->SetPosition(x, y);
    text->GetTextProperty()->SetFontSize(24);
    text->GetTextProperty()->SetColor(0.15, 0.15, 0.15);
    if (right) text->GetTextProperty()->SetJustificationToRight();
    renderer_->AddActor2D(text);
  }
  void add_legend(double fastest) {
    if (!(fastest > 0)) return;
    const vtkNew<vtkLookupTable> table;
    constexpr int steps = 128;
    table->SetNumberOfTableValues(steps);
    table->SetRange(0, fastest);
    for (int k = 0; k < steps; ++k) {
      const Colour colour = blend(blues, k / (steps - 1.0));
      table->SetTableValue(k, colour[0], colour[1], colour[2]);
    }
    const vtkNew<vtkScalarBarActor> bar;
    bar->SetLookupTable(table);
    bar->SetTitle("speed of the water [m/s]");
    bar->SetOrientationToHorizontal();
    bar->SetPosition(0.03, 12.0 / height_);
    bar->SetWidth(0.25);
    bar->SetHeight(75.0 / height_);
    bar->SetNumberOfLabels(3);
    bar->SetVerticalTitleSeparation(8);
    bar->SetLabelFormat("%.2g");
    bar->UnconstrainedFontSizeOn();
    for (vtkTextProperty* text : {bar->GetTitleTextProperty(), bar->GetLabelTextProperty()}) {
      text->SetColor(0.15, 0.15, 0.15);
      text->SetFontSize(18);
      text->ItalicOff();
      text->BoldOff();
      text->ShadowOff();
    }
    renderer_->AddActor2D(bar);
  }

  bool flat_;
  int height_ = 800;
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkRenderWindow> window_;
  vtkNew<vtkPointGaussianMapper> mapper_;
  vtkNew<vtkTextActor> clock_;
};

void make_film(const fs::path& frames, const fs::path& film, Movie& movie) {
  const fs::path log = frames / "ffmpeg.log";
  const fs::path partial = frames / "film.mp4";
  std::error_code ignored;
  int status = 0;
  try {
    status = ChildProcess({"ffmpeg", "-y", "-framerate", "10", "-i", (frames / "f%05d.png").string(), "-c:v", "libx264",
                           "-crf", "18", "-pix_fmt", "yuv420p", partial.string()},
                          {.log = log})
                 .wait();
  } catch (const StartError&) {
    movie.warnings.emplace_back(
        "--movie: there are frames but no film, for ffmpeg is not installed; apt-get install ffmpeg");
    fs::remove(log, ignored);
    return;
  }
  if (status != 0) {
    movie.warnings.push_back("--movie: ffmpeg failed; what it said is in " + log.string());
    return;
  }
  fs::rename(partial, film);
  movie.film = film;
  fs::remove(log, ignored);
}

}  // namespace

Movie make_movie(const RunFolder& run, const Case& resolved) {
  Movie movie;
  const SnapshotList list = find_snapshots(run);
  const Display display;
  if (!display.why_not().empty()) {
    movie.warnings.push_back("--movie: " + display.why_not());
    return movie;
  }
  Room room;
  for (const SeriesEntry& entry : {list.entries.front(), list.entries[list.entries.size() / 2], list.entries.back()}) {
    room.add(read_particles(entry.file));
  }
  const fs::path folder = run.root / "movie";
  fs::remove_all(folder);
  const ParticleSet last = read_particles(list.entries.back().file);
  const bool by_state = std::any_of(last.state.begin(), last.state.end(),
                                    [](SedimentState state) { return state != SedimentState::none; });
  Stage stage(room, last.info, resolved.info.title.empty() ? resolved.info.name : resolved.info.title, by_state);
  for (const SeriesEntry& entry : list.entries) {
    try {
      const ParticleSet particles = read_particles(entry.file);
      stage.draw(coloured(particles, room, by_state), entry.time, folder / fmt::format("f{:05}.png", movie.frames));
      ++movie.frames;
    } catch (const InputError& error) {
      movie.warnings.push_back(std::string("--movie: skipped: ") + error.what());
    }
  }
  make_film(folder, run.root / "movie.mp4", movie);
  return movie;
}

}  // namespace thalweg
