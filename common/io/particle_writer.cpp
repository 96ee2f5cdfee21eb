#include "common/io/particle_file.hpp"

#include <vtkAOSDataArrayTemplate.h>
#include <vtkCellArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <numeric>
#include <string_view>
#include <type_traits>

#include "common/error.hpp"
#include "common/io/particle_names.hpp"
#include "common/io/particle_skeleton.hpp"
#include "common/io/poly_data_file.hpp"
#include "common/particle_arrays.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

// A VTK array over memory that the particle set owns and the writer only reads.
template <class T>
vtkSmartPointer<vtkAOSDataArrayTemplate<T>> view(const char* name, const T* data, std::size_t values, int components) {
  auto array = vtkSmartPointer<vtkAOSDataArrayTemplate<T>>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetArray(const_cast<T*>(data), static_cast<vtkIdType>(values), 1);
  return array;
}

class Writer {
 public:
  /// `total`: the number of the file's particles, of which a skeleton (particle_skeleton.hpp) has two.
  Writer(const fs::path& file, const ParticleSet& particles, std::int64_t total)
      : file_(file), particles_(particles), total_(total) {}

  vtkSmartPointer<vtkPolyData> poly_data(PositionPrecision precision, const std::map<std::string, std::string>& texts) {
    points(precision);
    vertices();
    for_each_array(particles_, [&](const char* name, const auto& values) {
      if (name == std::string_view(particle_names::mass) && has_one_mass()) {
        add_fact(data_, name, particles_.mass.front());
      } else {
        add(name, values);
      }
    });
    for (const auto& [name, values] : particles_.scalars) add_further(name, values);
    for (const auto& [name, values] : particles_.doubles) add_further(name, values);
    add_facts(data_, particles_.info);
    add_fact(data_, particle_names::count, total_);
    if (const auto& node = particles_.info.lattice_node) add_fact(data_, particle_names::lattice_node, *node);
    for (const auto& [name, numbers] : particles_.facts) {
      data_->GetFieldData()->AddArray(view(name.c_str(), numbers.data(), numbers.size(), 1));
    }
    for (const auto& [name, text] : texts) add_fact(data_, name.c_str(), text);
    return data_;
  }

 private:
  [[noreturn]] void reject(const std::string& name, const std::string& what) const {
    throw RunError(file_.string() + ": cannot be written: array " + name + " " + what);
  }

  template <class T>
  void add(const char* name, const std::vector<T>& values) {
    if constexpr (std::is_enum_v<T>) {
      array(name, reinterpret_cast<const std::underlying_type_t<T>*>(values.data()), values.size(), 1);
    } else {
      array(name, values.data(), values.size(), 1);
    }
  }
  void add(const char* name, const std::vector<Eigen::Vector3f>& values) {
    array(name, values.empty() ? nullptr : values.front().data(), 3 * values.size(), 3);
  }

  template <class T>
  void array(const char* name, const T* values, std::size_t count, int components) {
    if (count == 0) return;
    if (count != particles_.size() * static_cast<std::size_t>(components)) {
      reject(name, "has " + std::to_string(count) + " values for " + std::to_string(particles_.size()) + " particles");
    }
    data_->GetPointData()->AddArray(view(name, values, count, components));
  }

  // An array of `scalars` or `doubles`, with as many components as its size tells.
  template <class T>
  void add_further(const std::string& name, const std::vector<T>& values) {
    if (data_->GetPointData()->HasArray(name.c_str()) != 0) reject(name, "has the name of another array");
    const std::size_t components =
        particles_.size() == 0 ? 1 : std::max<std::size_t>(1, values.size() / particles_.size());
    array(name.c_str(), values.data(), values.size(), static_cast<int>(components));
  }

  [[nodiscard]] PositionPrecision sufficient(PositionPrecision asked) const {
    double farthest = 0;
    for (const Vec3& p : particles_.position) farthest = std::max(farthest, p.cwiseAbs().maxCoeff());
    return sufficient_precision(asked, farthest, particles_.info.spacing);
  }

  void points(PositionPrecision asked) {
    const PositionPrecision precision = sufficient(asked);
    vtkNew<vtkPoints> points;
    const std::size_t n = particles_.size();
    if (particles_.position.size() != n || particles_.type.size() != n) reject("Position or Type", "is incomplete");
    if (n == 0) {
      points->SetDataType(precision == PositionPrecision::double_precision ? VTK_DOUBLE : VTK_FLOAT);
    } else if (precision == PositionPrecision::double_precision) {
      points->SetData(view("Points", particles_.position.front().data(), 3 * n, 3));
    } else {
      single_.resize(3 * n);
      std::transform(particles_.position.front().data(), particles_.position.front().data() + 3 * n, single_.begin(),
                     [](double value) { return static_cast<float>(value); });
      points->SetData(view("Points", single_.data(), 3 * n, 3));
    }
    data_->SetPoints(points);
  }

  // One vertex per particle, so that ParaView draws them and its cell filters can choose among them.
  void vertices() {
    const auto n = static_cast<vtkIdType>(particles_.size());
    vtkNew<vtkIdTypeArray> offsets;
    offsets->SetNumberOfValues(n + 1);
    std::iota(offsets->GetPointer(0), offsets->GetPointer(0) + n + 1, vtkIdType{0});
    vtkNew<vtkIdTypeArray> connectivity;
    connectivity->SetNumberOfValues(n);
    std::iota(connectivity->GetPointer(0), connectivity->GetPointer(0) + n, vtkIdType{0});
    if (n > 0) {
      offsets->SetValue(n, total_);
      connectivity->SetValue(n - 1, total_ - 1);
    }
    vtkNew<vtkCellArray> cells;
    cells->SetData(offsets, connectivity);
    data_->SetVerts(cells);
  }

  // A mass that all particles have is written once.
  [[nodiscard]] bool has_one_mass() const {
    const std::vector<float>& mass = particles_.mass;
    return !mass.empty() && mass.size() == particles_.size() &&
           std::all_of(mass.begin(), mass.end(), [&](float value) { return value == mass.front(); });
  }

  const fs::path& file_;
  const ParticleSet& particles_;
  std::int64_t total_;
  std::vector<float> single_;
  vtkSmartPointer<vtkPolyData> data_ = vtkSmartPointer<vtkPolyData>::New();
};

}  // namespace

void write_particles(const fs::path& file, const ParticleSet& particles, PositionPrecision precision,
                     const std::map<std::string, std::string>& texts, const WholeFile& how) {
  Writer contents(file, particles, static_cast<std::int64_t>(particles.size()));
  write_poly_data(file, contents.poly_data(precision, texts), how);
}

std::string particle_skeleton(const fs::path& file, const ParticleSet& extremes, std::int64_t total,
                              PositionPrecision precision, const std::map<std::string, std::string>& texts) {
  Writer contents(file, extremes, total);
  return poly_data_text(file, contents.poly_data(precision, texts));
}

}  // namespace thalweg
