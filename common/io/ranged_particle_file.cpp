#include "common/io/ranged_particle_file.hpp"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "common/error.hpp"
#include "common/io/file_seal.hpp"
#include "common/io/particle_file.hpp"
#include "common/io/particle_skeleton.hpp"
#include "common/particle_arrays.hpp"
#include "common/whole_file.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

/// Names of arrays that a particle file has beside those of the set.
constexpr const char* array_of_points = "Points";
constexpr const char* array_of_vertices = "connectivity";
constexpr const char* array_of_offsets = "offsets";

/// Numbers of the components of an entry.
template <class T>
constexpr std::size_t components_of = 1;
template <>
constexpr std::size_t components_of<Eigen::Vector3f> = 3;
template <>
constexpr std::size_t components_of<Vec3> = 3;

/// The number by which a file gives the range of an array: of several components their squared length.
template <class T>
double range_measure(const T* entry, std::size_t components) {
  if constexpr (std::is_enum_v<T>) {
    return static_cast<double>(static_cast<std::underlying_type_t<T>>(*entry));
  } else if constexpr (components_of<T> > 1) {
    return range_measure(entry->data(), components_of<T>);
  } else {
    if (components == 1) return static_cast<double>(*entry);
    double sum = 0;
    for (std::size_t c = 0; c < components; ++c) sum += static_cast<double>(entry[c]) * static_cast<double>(entry[c]);
    return sum;
  }
}

template <class T>
std::string_view entry_bytes(const std::vector<T>& array) {
  return {reinterpret_cast<const char*>(array.data()), array.size() * sizeof(T)};
}

/// The name of an array if a line of the file begins one, else nothing.
std::string_view array_in(std::string_view line) {
  constexpr std::string_view mark = "Name=\"";
  if (line.find("<DataArray ") == std::string_view::npos) return {};
  const auto at = line.find(mark);
  if (at == std::string_view::npos) return {};
  line.remove_prefix(at + mark.size());
  return line.substr(0, line.find('"'));
}

/// The file on its way to the disk.
class SealedStream {
 public:
  SealedStream(const fs::path& temporary, const fs::path& file) : file_(file), to_(temporary, std::ios::binary) {
    check();
  }
  void write(std::string_view text) {
    seal_.add(text);
    put(text);
  }
  void end() {
    put(seal_.text());
    to_.close();
    check();
  }

 private:
  void put(std::string_view text) {
    to_.write(text.data(), static_cast<std::streamsize>(text.size()));
    check();
  }
  void check() const {
    if (!to_) throw RunError(file_.string() + ": cannot be written; check the folder's permissions and free space");
  }

  const fs::path& file_;
  std::ofstream to_;
  Seal seal_;
};

}  // namespace

RangedParticleFile::RangedParticleFile(fs::path file) : file_(std::move(file)) {
  if (file_.has_parent_path()) fs::create_directories(file_.parent_path());
}

BlockSpool& RangedParticleFile::spool(const std::string& of_file) {
  std::unique_ptr<BlockSpool>& spool = spools_[of_file];
  if (spool == nullptr) {
    // The name of a temporary file (whole_file.hpp), so that one that is left behind is found.
    const std::string name =
        "." + file_.stem().string() + "-" + std::to_string(spools_.size()) + "." + std::to_string(getpid()) + ".part";
    spool = std::make_unique<BlockSpool>(file_.parent_path() / name);
  }
  return *spool;
}

template <class T>
void RangedParticleFile::add_array(const std::string& of_file, const std::vector<T>& array, std::vector<T>& extremes,
                                   std::size_t n) {
  const bool is_new = size_ == 0;
  if (array.empty() && (is_new || extremes.empty())) return;
  const std::size_t entries = is_new ? array.size() / n : extremes.size() / 2;
  if (array.size() != n * entries || entries == 0 || (!is_new && extremes.empty())) {
    throw RunError(file_.string() + ": cannot be written: array " + of_file + " does not fit its range of particles");
  }
  if (is_new) {
    extremes.assign(array.begin(), array.begin() + static_cast<std::ptrdiff_t>(entries));
    extremes.insert(extremes.end(), extremes.begin(), extremes.begin() + static_cast<std::ptrdiff_t>(entries));
  }
  double least = range_measure(extremes.data(), entries);
  double most = range_measure(extremes.data() + entries, entries);
  for (std::size_t i = 0; i < n; ++i) {
    const T* entry = array.data() + i * entries;
    const double size = range_measure(entry, entries);
    if (size < least) least = size, std::copy_n(entry, entries, extremes.data());
    if (size > most) most = size, std::copy_n(entry, entries, extremes.data() + entries);
  }
  spool(of_file).add(entry_bytes(array));
}

void RangedParticleFile::add(const ParticleSet& range) {
  const std::size_t n = range.size();
  if (n == 0) return;
  for_each_array(extremes_, [&](const char* name, auto& extremes) {
    for_each_array(range, [&](const char* other, const auto& array) {
      if constexpr (std::is_same_v<std::remove_cvref_t<decltype(array)>, std::remove_cvref_t<decltype(extremes)>>) {
        if (std::string_view(name) == other) add_array(name, array, extremes, n);
      }
    });
  });
  add_array(array_of_points, range.position, extremes_.position, n);
  for (const auto& [name, array] : range.scalars) add_array(name, array, extremes_.scalars[name], n);
  for (const auto& [name, array] : range.doubles) add_array(name, array, extremes_.doubles[name], n);
  size_ += static_cast<std::int64_t>(n);
}

/// One vertex a particle (particle_writer.cpp).
void RangedParticleFile::add_vertices() {
  constexpr std::int64_t at_once = 1 << 16;
  for (std::int64_t from = 0; from < size_; from += at_once) {
    std::vector<std::int64_t> numbers;
    for (std::int64_t i = from; i < std::min(size_, from + at_once); ++i) numbers.push_back(i);
    spool(array_of_vertices).add(entry_bytes(numbers));
    for (std::int64_t& number : numbers) ++number;
    spool(array_of_offsets).add(entry_bytes(numbers));
  }
}

/// A skeleton has two particles. One alone is written as it is: it is both the least and the largest.
void RangedParticleFile::write_only_particle() {
  const auto halve = [](auto& array) { array.resize(array.size() / 2); };
  for_each_array(extremes_, [&](const char*, auto& array) { halve(array); });
  halve(extremes_.position);
  for (auto& [name, array] : extremes_.scalars) halve(array);
  for (auto& [name, array] : extremes_.doubles) halve(array);
  write_particles(file_, extremes_, PositionPrecision::double_precision);
}

void RangedParticleFile::finish(const ParticleFileInfo& info) {
  if (size_ < 1) throw RunError(file_.string() + ": cannot be written: there are no particles");
  extremes_.info = info;
  if (size_ == 1) return write_only_particle();
  add_vertices();
  std::string skeleton = particle_skeleton(file_, extremes_, size_);
  for (const std::string attribute : {"NumberOfPoints=\"", "NumberOfVerts=\""}) {
    const auto at = skeleton.find(attribute + "2\"");
    if (at == std::string::npos) throw std::logic_error("a particle file without " + attribute);
    skeleton.replace(at + attribute.size(), 1, std::to_string(size_));
  }
  write_whole_file(file_, [&](const fs::path& temporary) {
    SealedStream to(temporary, file_);
    bool of_particles = false;  // arrays of particles come between field data and lines
    std::string_view left = skeleton;
    while (!left.empty()) {
      const std::string_view line = left.substr(0, left.find('\n') + 1);
      left.remove_prefix(line.size());
      to.write(line);
      if (line.find("<PointData>") != std::string_view::npos) of_particles = true;
      if (line.find("<Lines>") != std::string_view::npos) of_particles = false;
      const std::string_view name = of_particles ? array_in(line) : std::string_view();
      if (name.empty()) continue;
      const std::string_view body = left.substr(0, left.find('\n') + 1);
      left.remove_prefix(body.size());
      to.write(body.substr(0, body.find_first_not_of(' ')));
      spools_.at(std::string(name))->write_to([&](std::string_view text) { to.write(text); });
      to.write("\n");
    }
    to.end();
  });
}

}  // namespace thalweg
