#include "common/io/particle_file.hpp"

#include <vtkAOSDataArrayTemplate.h>
#include <vtkArrayDispatch.h>
#include <vtkCellArray.h>
#include <vtkDataArrayRange.h>
#include <vtkDataArraySelection.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/error.hpp"
#include "common/io/vtk_errors.hpp"
#include "common/whole_file.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

// Names of docs/file-formats.md.
constexpr const char* name_id = "Id";
constexpr const char* name_type = "Type";
constexpr const char* name_state = "State";
constexpr const char* name_velocity = "Velocity";
constexpr const char* name_density = "Density";
constexpr const char* name_pressure = "Pressure";
constexpr const char* name_mass = "Mass";
constexpr const char* name_viscosity = "Viscosity";
constexpr const char* name_normal = "Normal";
constexpr const char* name_case = "CaseName";
constexpr const char* name_version = "CodeVersion";
constexpr const char* name_hash = "CaseHash";
constexpr const char* name_dimension = "Dimension";
constexpr const char* name_spacing = "Spacing";
constexpr const char* name_smoothing = "SmoothingLength";
constexpr const char* name_time = "TimeValue";
constexpr const char* name_step = "Step";

// ---------------------------------------------------------------------------------------------------------- writing

// A VTK array over memory that somebody else owns and only the writer reads.
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
  Writer(const fs::path& file, const ParticleSet& particles) : file_(file), particles_(particles) {}

  vtkSmartPointer<vtkPolyData> poly_data(PositionPrecision precision) {
    points(precision);
    vertices();
    const ParticleSet& p = particles_;
    array(name_id, p.id.data(), p.id.size(), 1);
    array(name_type, reinterpret_cast<const unsigned char*>(p.type.data()), p.type.size(), 1);
    array(name_state, reinterpret_cast<const unsigned char*>(p.state.data()), p.state.size(), 1);
    array(name_velocity, p.velocity.empty() ? nullptr : p.velocity.front().data(), p.velocity.size() * 3, 3);
    array(name_density, p.density.data(), p.density.size(), 1);
    array(name_pressure, p.pressure.data(), p.pressure.size(), 1);
    mass();
    array(name_viscosity, p.viscosity.data(), p.viscosity.size(), 1);
    array(name_normal, p.normal.empty() ? nullptr : p.normal.front().data(), p.normal.size() * 3, 3);
    for (const auto& [name, values] : p.scalars) further(name, values);
    for (const auto& [name, values] : p.doubles) further(name, values);
    facts();
    return data_;
  }

 private:
  [[noreturn]] void reject(const std::string& name, const std::string& what) const {
    throw RunError(file_.string() + ": cannot be written: array " + name + " " + what);
  }

  template <class T>
  void array(const char* name, const T* values, std::size_t count, int components) {
    if (count == 0) return;
    if (count != particles_.size() * static_cast<std::size_t>(components)) {
      reject(name, "has " + std::to_string(count) + " values for " + std::to_string(particles_.size()) + " particles");
    }
    data_->GetPointData()->AddArray(view(name, values, count, components));
  }

  template <class T>
  void further(const std::string& name, const std::vector<T>& values) {
    if (data_->GetPointData()->HasArray(name.c_str()) != 0) reject(name, "has the name of another array");
    const std::size_t components =
        particles_.size() == 0 ? 1 : std::max<std::size_t>(1, values.size() / particles_.size());
    array(name.c_str(), values.data(), values.size(), static_cast<int>(components));
  }

  void points(PositionPrecision precision) {
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
    vtkNew<vtkCellArray> cells;
    cells->SetData(offsets, connectivity);
    data_->SetVerts(cells);
  }

  void mass() {
    const std::vector<float>& mass = particles_.mass;
    const bool constant = !mass.empty() && mass.size() == particles_.size() &&
                          std::all_of(mass.begin(), mass.end(), [&](float value) { return value == mass.front(); });
    if (constant) {
      fact(name_mass, mass.front());
    } else {
      array(name_mass, mass.data(), mass.size(), 1);
    }
  }

  template <class T>
  void fact(const char* name, T value) {
    vtkNew<vtkAOSDataArrayTemplate<T>> one;
    one->SetName(name);
    one->InsertNextValue(value);
    data_->GetFieldData()->AddArray(one);
  }
  void fact(const char* name, const std::string& value) {
    vtkNew<vtkStringArray> one;
    one->SetName(name);
    one->InsertNextValue(value);
    data_->GetFieldData()->AddArray(one);
  }

  void facts() {
    const ParticleFileInfo& info = particles_.info;
    fact(name_time, info.time);
    fact<vtkTypeInt64>(name_step, info.step);
    fact<int>(name_dimension, info.dimension);
    fact(name_spacing, info.spacing);
    fact(name_smoothing, info.smoothing_length);
    fact(name_case, info.case_name);
    fact(name_version, info.code_version);
    fact(name_hash, info.case_hash);
  }

  const fs::path& file_;
  const ParticleSet& particles_;
  std::vector<float> single_;
  vtkSmartPointer<vtkPolyData> data_ = vtkSmartPointer<vtkPolyData>::New();
};

// ---------------------------------------------------------------------------------------------------------- reading

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
    set.id = values<std::int64_t>(name_id, 1, true);
    set.type = enumeration<ParticleType>(name_type, true);
    set.state = enumeration<SedimentState>(name_state, false);
    set.velocity = vectors(name_velocity);
    set.density = values<float>(name_density, 1, false);
    set.pressure = values<float>(name_pressure, 1, false);
    set.mass = mass();
    set.viscosity = values<float>(name_viscosity, 1, false);
    set.normal = vectors(name_normal);
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
    info.case_name = fact(name_case);
    info.code_version = fact(name_version);
    info.case_hash = fact(name_hash);
    info.dimension = static_cast<int>(fact(name_dimension, info.dimension));
    info.spacing = fact(name_spacing, 0);
    info.smoothing_length = fact(name_smoothing, 0);
    info.time = fact(name_time, 0);
    info.step = static_cast<std::int64_t>(fact(name_step, 0));
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
    std::vector<float> mass = values<float>(name_mass, 1, false);
    auto* constant = vtkDataArray::SafeDownCast(field(name_mass));
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
    constexpr std::array known{name_id,       name_type, name_state,     name_velocity, name_density,
                               name_pressure, name_mass, name_viscosity, name_normal};
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

void write_particles(const fs::path& file, const ParticleSet& particles, PositionPrecision precision) {
  Writer contents(file, particles);
  const vtkSmartPointer<vtkPolyData> data = contents.poly_data(precision);
  write_whole_file(file, [&](const fs::path& temporary) {
    vtkNew<vtkXMLPolyDataWriter> writer;
    vtkNew<VtkErrors> errors;
    writer->AddObserver(vtkCommand::ErrorEvent, errors);
    writer->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
    writer->SetInputData(data);
    writer->SetFileName(temporary.c_str());
    // Appended raw data would be a quarter smaller, but since the expat of Debian 12.12 ParaView 5.11 cannot open them.
    writer->SetDataModeToBinary();
    writer->SetCompressorTypeToZLib();
    writer->SetCompressionLevel(1);  // higher levels cost several times the time for a few per cent of size
    writer->SetHeaderTypeToUInt64();
    if (writer->Write() == 0 || writer->GetErrorCode() != vtkErrorCode::NoError || errors->any()) {
      const std::string cause = writer->GetErrorCode() != vtkErrorCode::NoError
                                    ? vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode())
                                    : errors->first();
      throw RunError(file.string() + ": cannot be written: " + cause +
                     "; check the folder's permissions and free space");
    }
  });
}

ParticleSet read_particles(const fs::path& file) { return Reader(file).particles(); }

ParticleFileInfo read_particle_info(const fs::path& file) { return Reader(file).info_only(); }

}  // namespace thalweg
