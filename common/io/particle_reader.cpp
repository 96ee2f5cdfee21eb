#include "common/io/particle_file.hpp"

#include <vtkArrayDispatch.h>
#include <vtkDataArrayRange.h>
#include <vtkDataArraySelection.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <array>

#include "common/error.hpp"
#include "common/io/particle_names.hpp"
#include "common/io/vtk_errors.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

class Reader {
 public:
  explicit Reader(const fs::path& file) : file_(file) {
    if (!fs::is_regular_file(file)) reject("there is no such file", "check the name, or run the program that makes it");
    reader_->AddObserver(vtkCommand::ErrorEvent, errors_);
    reader_->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors_);
    reader_->SetReaderErrorObserver(errors_);
    reader_->SetParserErrorObserver(errors_);
    reader_->SetFileName(file.c_str());
    reader_->UpdateInformation();
    check();
  }

  ParticleFileInfo info_only() {
    reader_->GetPointDataArraySelection()->DisableAllArrays();
    reader_->Update();
    check();
    return info();
  }

  ParticleSet particles() {
    reader_->Update();
    check();
    data_ = reader_->GetOutput();
    count_ = static_cast<std::size_t>(data_->GetNumberOfPoints());
    ParticleSet set;
    set.info = info();
    positions(set);
    set.id = values<std::int64_t>(particle_names::id, 1, true);
    set.type = enumeration<ParticleType>(particle_names::type, true);
    set.state = enumeration<SedimentState>(particle_names::state, false);
    set.velocity = vectors(particle_names::velocity);
    set.density = values<float>(particle_names::density, 1, false);
    set.pressure = values<float>(particle_names::pressure, 1, false);
    set.mass = mass();
    set.viscosity = values<float>(particle_names::viscosity, 1, false);
    set.normal = vectors(particle_names::normal);
    further(set);
    return set;
  }

 private:
  [[noreturn]] void reject(const std::string& what, const std::string& cure) const {
    throw InputError(file_.string() + ": " + what + "; " + cure);
  }

  void check() const {
    if (errors_->any()) {
      reject("is not a complete VTK PolyData file (" + errors_->first() + ")",
             "it may have been cut off: write it again");
    }
  }

  vtkAbstractArray* field(const char* name) { return reader_->GetOutput()->GetFieldData()->GetAbstractArray(name); }
  [[nodiscard]] double fact(const char* name, double otherwise) {
    auto* array = vtkDataArray::SafeDownCast(field(name));
    return array != nullptr && array->GetNumberOfTuples() > 0 ? array->GetComponent(0, 0) : otherwise;
  }
  [[nodiscard]] std::string fact(const char* name) {
    auto* array = vtkStringArray::SafeDownCast(field(name));
    return array != nullptr && array->GetNumberOfValues() > 0 ? array->GetValue(0) : std::string();
  }

  ParticleFileInfo info() {
    ParticleFileInfo info;
    info.case_name = fact(particle_names::case_name);
    info.code_version = fact(particle_names::version);
    info.case_hash = fact(particle_names::hash);
    info.dimension = static_cast<int>(fact(particle_names::dimension, info.dimension));
    info.spacing = fact(particle_names::spacing, 0);
    info.smoothing_length = fact(particle_names::smoothing, 0);
    info.time = fact(particle_names::time, 0);
    info.step = static_cast<std::int64_t>(fact(particle_names::step, 0));
    return info;
  }

  // Numbers of `array` as T, whatever type the file has them in; never by way of double, which would round ids.
  template <class T>
  std::vector<T> converted(vtkDataArray* array) const {
    std::vector<T> numbers;
    numbers.reserve(static_cast<std::size_t>(array->GetNumberOfValues()));
    const auto copy = [&](auto* typed) {
      for (const auto value : vtk::DataArrayValueRange(typed)) numbers.push_back(static_cast<T>(value));
    };
    if (!vtkArrayDispatch::Dispatch::Execute(array, copy)) {
      reject(std::string("array ") + array->GetName() + " is of an unknown type",
             "use the types of docs/file-formats.md");
    }
    return numbers;
  }

  template <class T>
  std::vector<T> values(const char* name, int components, bool needed) const {
    vtkDataArray* array = data_->GetPointData()->GetArray(name);
    if (array == nullptr) {
      if (needed && count_ > 0) reject(std::string("has no point array ") + name, "particle files need Id and Type");
      return {};
    }
    if (array->GetNumberOfComponents() != components) {
      reject(std::string("array ") + name + " has " + std::to_string(array->GetNumberOfComponents()) + " components",
             "it needs " + std::to_string(components));
    }
    return converted<T>(array);
  }

  template <class E>
  std::vector<E> enumeration(const char* name, bool needed) const {
    const std::vector<int> numbers = values<int>(name, 1, needed);
    std::vector<E> result(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (numbers[i] < 0 || numbers[i] > 3) {
        reject(
            std::string("array ") + name + " holds " + std::to_string(numbers[i]) + " at particle " + std::to_string(i),
            "it must be 0 to 3, see docs/file-formats.md");
      }
      result[i] = static_cast<E>(numbers[i]);
    }
    return result;
  }

  std::vector<Eigen::Vector3f> vectors(const char* name) const {
    const std::vector<float> flat = values<float>(name, 3, false);
    std::vector<Eigen::Vector3f> result(flat.size() / 3);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = {flat[3 * i], flat[3 * i + 1], flat[3 * i + 2]};
    return result;
  }

  std::vector<float> mass() {
    std::vector<float> mass = values<float>(particle_names::mass, 1, false);
    auto* constant = vtkDataArray::SafeDownCast(field(particle_names::mass));
    if (mass.empty() && constant != nullptr && constant->GetNumberOfTuples() == 1) {
      mass.assign(count_, static_cast<float>(constant->GetComponent(0, 0)));
    }
    return mass;
  }

  void positions(ParticleSet& set) const {
    if (count_ == 0) return;
    const std::vector<double> flat = converted<double>(data_->GetPoints()->GetData());
    set.position.resize(count_);
    for (std::size_t i = 0; i < count_; ++i) {
      set.position[i] = {flat[3 * i], flat[3 * i + 1], flat[3 * i + 2]};
      if (!set.position[i].allFinite()) {
        reject("the position of particle " + std::to_string(i) + " is not finite", "write the file again");
      }
    }
  }

  void further(ParticleSet& set) const {
    constexpr std::array known{particle_names::id,       particle_names::type,      particle_names::state,
                               particle_names::velocity, particle_names::density,   particle_names::pressure,
                               particle_names::mass,     particle_names::viscosity, particle_names::normal};
    vtkPointData* arrays = data_->GetPointData();
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i) {
      vtkDataArray* array = arrays->GetArray(i);
      if (array == nullptr || array->GetName() == nullptr) continue;
      const std::string name = array->GetName();
      if (std::find(known.begin(), known.end(), name) != known.end()) continue;
      if (array->GetDataType() == VTK_FLOAT) {
        set.scalars[name] = converted<float>(array);
      } else {
        set.doubles[name] = converted<double>(array);
      }
    }
  }

  const fs::path& file_;
  vtkNew<VtkErrors> errors_;
  vtkNew<vtkXMLPolyDataReader> reader_;
  vtkPolyData* data_ = nullptr;
  std::size_t count_ = 0;
};

}  // namespace

ParticleSet read_particles(const fs::path& file) { return Reader(file).particles(); }

ParticleFileInfo read_particle_info(const fs::path& file) { return Reader(file).info_only(); }

}  // namespace thalweg
