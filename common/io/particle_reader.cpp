#include "common/io/particle_file.hpp"

#include <fmt/format.h>
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
#include <set>
#include <string_view>
#include <type_traits>

#include "common/error.hpp"
#include "common/io/file_seal.hpp"
#include "common/io/particle_frame.hpp"
#include "common/io/particle_names.hpp"
#include "common/io/poly_data_check.hpp"
#include "common/io/ranged_particle_reader.hpp"
#include "common/io/vtk_errors.hpp"
#include "common/particle_arrays.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

class Reader {
 public:
  explicit Reader(const fs::path& file) : file_(file) {
    if (!fs::is_regular_file(file)) reject("there is no such file", "check the name, or run the program that makes it");
    if (seal_state(file) == SealState::broken) {
      reject("is damaged: its checksum does not fit its contents", "take an earlier copy, or write it again");
    }
    check_poly_data(file);
    reader_->SetFileName(file.c_str());
    begin();
  }
  /// Of the text of a file.
  Reader(const fs::path& file, const std::string& text) : file_(file) {
    check_poly_data(file, text);
    reader_->ReadFromInputStringOn();
    reader_->SetInputString(text);
    begin();
  }

  ParticleFrame frame(std::uint64_t particles) {
    read_data();
    count_ = particles;
    check_count();
    ParticleFrame frame;
    frame.set.info = info();
    read_facts(frame.set);
    read_texts(frame.texts);
    frame.mass = constant_mass();
    return frame;
  }

  ParticleFileInfo info_only() {
    reader_->GetPointDataArraySelection()->DisableAllArrays();
    reader_->Update();
    check();
    return info();
  }

  ParticleSet particles() {
    read_data();
    count_ = static_cast<std::size_t>(data_->GetNumberOfPoints());
    ParticleSet set;
    set.info = info();
    check_count();
    positions(set);
    std::set<std::string> members;
    for_each_array(set, [&](const char* name, auto& array) {
      read(name, array);
      members.insert(name);
    });
    if (count_ > 0 && set.id.empty()) reject("has no point array Id", "particle files need Id and Type");
    if (count_ > 0 && set.type.empty()) reject("has no point array Type", "particle files need Id and Type");
    if (const auto mass = constant_mass(); mass && set.mass.empty()) set.mass.assign(count_, *mass);
    read_further(set, members);
    read_facts(set);
    return set;
  }

  // Every text of the field data; after particles().
  void read_texts(std::map<std::string, std::string>& texts) const {
    vtkFieldData* facts = data_->GetFieldData();
    for (int i = 0; i < facts->GetNumberOfArrays(); ++i) {
      auto* array = vtkStringArray::SafeDownCast(facts->GetAbstractArray(i));
      if (array == nullptr || array->GetName() == nullptr || array->GetNumberOfValues() == 0) continue;
      texts[array->GetName()] = array->GetValue(0);
    }
  }

 private:
  [[noreturn]] void reject(const std::string& what, const std::string& cure) const {
    throw InputError(file_.string() + ": " + what + "; " + cure);
  }

  void begin() {
    reader_->AddObserver(vtkCommand::ErrorEvent, errors_);
    reader_->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors_);
    reader_->SetReaderErrorObserver(errors_);
    reader_->SetParserErrorObserver(errors_);
    reader_->UpdateInformation();
    check();
  }

  void read_data() {
    reader_->Update();
    check();
    data_ = reader_->GetOutput();
  }

  void check_count() {
    const double written = fact(particle_names::count, static_cast<double>(count_));
    if (written == static_cast<double>(count_)) return;
    reject(
        fmt::format("holds {} particles, and {:.0f} were written", count_, written),
        fmt::format("take the whole file, or take {} out of its field data if this is meant", particle_names::count));
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
  /// A fact within its limits.
  [[nodiscard]] double number(const char* name, double otherwise, double least, double most) {
    const double value = fact(name, otherwise);
    if (value >= least && value <= most) return value;
    reject(fmt::format("{} in its field data is {:g}", name, value),
           fmt::format("give a number from {:g} to {:g}", least, most));
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
    info.dimension = static_cast<int>(number(particle_names::dimension, info.dimension, 2, 3));
    info.spacing = number(particle_names::spacing, 0, 0, largest);
    info.smoothing_length = number(particle_names::smoothing, 0, 0, largest);
    info.time = number(particle_names::time, 0, 0, largest);
    info.step = static_cast<std::int64_t>(number(particle_names::step, 0, 0, 1e15));
    info.lattice_node = lattice_node();
    return info;
  }

  [[nodiscard]] std::optional<Vec3> lattice_node() {
    auto* array = vtkDataArray::SafeDownCast(field(particle_names::lattice_node));
    if (array == nullptr) return std::nullopt;
    Vec3 node = Vec3::Zero();
    const bool is_point = array->GetNumberOfTuples() == 1 && array->GetNumberOfComponents() == 3;
    if (is_point) array->GetTuple(0, node.data());
    if (!is_point || !node.allFinite()) {
      reject("LatticeNode in its field data is no point", "give one entry of three finite coordinates, or none");
    }
    return node;
  }

  // Numbers of `array` as T, from any type the file holds; never by way of double, which would round ids.
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
  std::vector<T> values(const char* name, int components) const {
    vtkDataArray* array = data_->GetPointData()->GetArray(name);
    if (array == nullptr) return {};
    if (array->GetNumberOfComponents() != components) {
      reject(std::string("array ") + name + " has " + std::to_string(array->GetNumberOfComponents()) + " components",
             "it needs " + std::to_string(components));
    }
    return converted<T>(array);
  }

  template <class Number>
  requires std::is_arithmetic_v<Number>
  void read(const char* name, std::vector<Number>& array) const { array = values<Number>(name, 1); }

  template <class Enum>
  requires std::is_enum_v<Enum>
  void read(const char* name, std::vector<Enum>& array) const {
    const std::vector<int> numbers = values<int>(name, 1);
    array.resize(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (numbers[i] < 0 || numbers[i] > 3) {
        reject(
            std::string("array ") + name + " holds " + std::to_string(numbers[i]) + " at particle " + std::to_string(i),
            "it must be 0 to 3, see docs/file-formats.md");
      }
      array[i] = static_cast<Enum>(numbers[i]);
    }
  }

  void read(const char* name, std::vector<Eigen::Vector3f>& array) const {
    const std::vector<float> flat = values<float>(name, 3);
    array.resize(flat.size() / 3);
    for (std::size_t i = 0; i < array.size(); ++i) array[i] = {flat[3 * i], flat[3 * i + 1], flat[3 * i + 2]};
  }

  // A mass that all particles have is one number in the field data.
  std::optional<float> constant_mass() {
    auto* constant = vtkDataArray::SafeDownCast(field(particle_names::mass));
    if (constant == nullptr || constant->GetNumberOfTuples() != 1) return std::nullopt;
    return static_cast<float>(constant->GetComponent(0, 0));
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
      if (set.position[i].cwiseAbs().maxCoeff() > largest) {
        reject(fmt::format("particle {} lies more than {:g} m from the origin", i, largest), "write the file again");
      }
    }
  }

  // Every array that is no member of ParticleSet, under its own name.
  void read_further(ParticleSet& set, const std::set<std::string>& members) const {
    vtkPointData* arrays = data_->GetPointData();
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i) {
      vtkDataArray* array = arrays->GetArray(i);
      if (array == nullptr || array->GetName() == nullptr || members.contains(array->GetName())) continue;
      if (array->GetDataType() == VTK_FLOAT) {
        set.scalars[array->GetName()] = converted<float>(array);
      } else {
        set.doubles[array->GetName()] = converted<double>(array);
      }
    }
  }

  // Every list of doubles in the field data that ParticleFileInfo does not know.
  void read_facts(ParticleSet& set) const {
    vtkFieldData* facts = data_->GetFieldData();
    for (int i = 0; i < facts->GetNumberOfArrays(); ++i) {
      vtkDataArray* array = facts->GetArray(i);
      if (array == nullptr || array->GetName() == nullptr || array->GetDataType() != VTK_DOUBLE) continue;
      const auto is_name = [&](const char* name) { return std::string_view(name) == array->GetName(); };
      if (std::any_of(particle_names::numbers.begin(), particle_names::numbers.end(), is_name)) continue;
      set.facts[array->GetName()] = converted<double>(array);
    }
  }

  static constexpr double largest = 1e9;  // [m], [s]

  const fs::path& file_;
  vtkNew<VtkErrors> errors_;
  vtkNew<vtkXMLPolyDataReader> reader_;
  vtkPolyData* data_ = nullptr;
  std::size_t count_ = 0;
};

}  // namespace

ParticleFrame read_particle_frame(const fs::path& file, const std::string& text, std::uint64_t particles) {
  return Reader(file, text).frame(particles);
}

ParticleSet read_particles(const fs::path& file, std::map<std::string, std::string>* texts) {
  // A file of ours without VTK's copies of its text and of its arrays.
  if (auto ours = RangedParticleReader::open(file)) {
    if (texts != nullptr) texts->insert(ours->texts().begin(), ours->texts().end());
    return ours->range(0, ours->size());
  }
  Reader reader(file);
  ParticleSet particles = reader.particles();
  if (texts != nullptr) reader.read_texts(*texts);
  return particles;
}

ParticleFileInfo read_particle_info(const fs::path& file) { return Reader(file).info_only(); }

}  // namespace thalweg
