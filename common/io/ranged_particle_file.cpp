#include "common/io/ranged_particle_file.hpp"

#include <unistd.h>

#include <fstream>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "common/error.hpp"
#include "common/io/file_seal.hpp"
#include "common/io/particle_file.hpp"
#include "common/io/particle_skeleton.hpp"
#include "common/particle_arrays.hpp"
#include "common/particle_extremes.hpp"
#include "common/whole_file.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

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

RangedParticleFile::RangedParticleFile(fs::path file, WholeFile how) : file_(std::move(file)), how_(std::move(how)) {
  if (how_.make_folders && file_.has_parent_path()) fs::create_directories(file_.parent_path());
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

void RangedParticleFile::refuse(const RunError& what) const {
  throw RunError(file_.string() + ": cannot be written: " + what.what());
}

void RangedParticleFile::add(const PackedRange& range) {
  try {
    widen(extremes_, range.extremes);
  } catch (const RunError& error) {
    refuse(error);
  }
  for (const auto& [name, pieces] : range.pieces) {
    BlockSpool& to = spool(name);
    for (const BlockPiece& piece : pieces) to.put(piece);
  }
  size_ += static_cast<std::int64_t>(range.particles);
}

void RangedParticleFile::add(const ParticleSet& range) {
  PackedRange packed;
  try {
    packed = packer_.add(range);
  } catch (const RunError& error) {
    refuse(error);
  }
  add(packed);
}

/// A skeleton has two particles. One alone is written as it is: it is both the least and the largest.
void RangedParticleFile::write_few(const ParticleFileFrame& frame) {
  const auto halve = [](auto& array) { array.resize(array.size() / 2); };
  for_each_array(extremes_, [&](const char*, auto& array) { halve(array); });
  halve(extremes_.position);
  for (auto& [name, array] : extremes_.scalars) halve(array);
  for (auto& [name, array] : extremes_.doubles) halve(array);
  write_particles(file_, extremes_, frame.precision, frame.texts, how_);
}

void RangedParticleFile::finish(const ParticleFileFrame& frame) {
  extremes_.info = frame.info;
  extremes_.facts = frame.facts;
  if (size_ < 2) return write_few(frame);
  add(packer_.end());
  std::string skeleton = particle_skeleton(file_, extremes_, size_, frame.precision, frame.texts);
  for (const std::string attribute : {"NumberOfPoints=\"", "NumberOfVerts=\""}) {
    const auto at = skeleton.find(attribute + "2\"");
    if (at == std::string::npos) throw std::logic_error("a particle file without " + attribute);
    skeleton.replace(at + attribute.size(), 1, std::to_string(size_));
  }
  const auto write = [&](const fs::path& temporary) {
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
      const auto spooled = spools_.extract(std::string(name));  // whose file is removed as soon as it is in this one
      spooled.mapped()->write_to([&](std::string_view text) { to.write(text); });
      to.write("\n");
    }
    to.end();
  };
  write_whole_file(file_, write, how_);
}

}  // namespace thalweg
