#include "common/io/ranged_particle_reader.hpp"

#include <fmt/format.h>
#include <vtkBase64Utilities.h>
#include <zlib.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <type_traits>

#include "common/error.hpp"
#include "common/io/file_seal.hpp"
#include "common/packed_particles.hpp"
#include "common/particle_arrays.hpp"

namespace thalweg {
namespace {

constexpr const char* numbers_of_a_piece = "NumberOfPoints";
constexpr const char* write_again = "write the file again";
constexpr const char* no_particles = R"(
    <Piece NumberOfPoints="0" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="0">
      <Points>
        <DataArray type="Float32" Name="Points" NumberOfComponents="3" format="ascii"></DataArray>
      </Points>
    </Piece>
  </PolyData>
</VTKFile>
)";
constexpr double farthest_place = 1e9;  // [m]

/// Characters of base64 for so many bytes from the beginning on.
std::uint64_t base64_size(std::uint64_t bytes) { return (bytes + 2) / 3 * 4; }

std::size_t width_of(const std::string& type) {
  if (type == "UInt8") return 1;
  if (type == "Float32") return 4;
  return type == "Int64" || type == "Float64" ? 8 : 0;
}

std::uint64_t number_in(const XmlElement& element, const char* name, std::uint64_t otherwise) {
  const std::string text = element.attribute(name);
  std::uint64_t number = otherwise;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

const XmlElement* child(const XmlElement& of, const char* name) {
  const auto found =
      std::find_if(of.children.begin(), of.children.end(), [&](const XmlElement& e) { return e.name == name; });
  return found == of.children.end() ? nullptr : &*found;
}

/// VTK's word for the numbers of an array's entries.
template <class T>
constexpr const char* type_of() {
  if constexpr (std::is_enum_v<T>) return "UInt8";
  if constexpr (std::is_same_v<T, std::int64_t>) return "Int64";
  return "Float32";
}

}  // namespace

RangedParticleReader::RangedParticleReader(const std::filesystem::path& file)
    : file_(file), stream_(file, std::ios::binary) {}

std::optional<RangedParticleReader> RangedParticleReader::open(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file) || seal_state(file) != SealState::whole) return std::nullopt;
  RangedParticleReader reader(file);
  if (!reader.find_arrays()) return std::nullopt;
  return reader;
}

void RangedParticleReader::reject(const std::string& what, const std::string& cure) const {
  throw InputError(fmt::format("{}: {}; {}", file_.string(), what, cure));
}

bool RangedParticleReader::find_arrays() {
  const XmlElement root = parse_xml(stream_, file_);
  stream_.clear();
  const XmlElement* content = child(root, "PolyData");
  const XmlElement* piece = content == nullptr ? nullptr : child(*content, "Piece");
  const bool is_ours = root.name == "VTKFile" && root.attribute("byte_order") == "LittleEndian" &&
                       root.attribute("header_type") == "UInt64" &&
                       root.attribute("compressor") == "vtkZLibDataCompressor" && piece != nullptr &&
                       &content->children.back() == piece;
  if (!is_ours) return false;
  size_ = number_in(*piece, numbers_of_a_piece, 0);
  const XmlElement* points = child(*piece, "Points");
  const XmlElement* data = child(*piece, "PointData");
  if (size_ == 0 || points == nullptr || points->children.size() != 1 || data == nullptr) return false;
  if (!add_array(points->children.front(), array_of_points)) return false;
  for (const XmlElement& element : data->children) {
    if (!add_array(element, element.attribute("Name"))) return false;
  }
  if (!has_types()) return false;
  read_frame(*piece);
  return true;
}

/// False for an array that is stored in another way than ours, or of a wrong size.
bool RangedParticleReader::add_array(const XmlElement& element, const std::string& name) {
  Array array;
  array.type = element.attribute("type");
  array.components = number_in(element, "NumberOfComponents", 1);
  array.bytes = array.components * width_of(array.type);
  if (array.bytes == 0 || element.attribute("format") != "binary" || name.empty()) return false;
  stream_.seekg(static_cast<std::streamoff>(element.begin));
  stream_ >> std::ws;
  array.text = stream_.tellg();
  constexpr std::size_t word = sizeof(std::uint64_t);
  std::uint64_t begin[3];
  std::memcpy(begin, decoded(array.text, 0, sizeof(begin)).data(), sizeof(begin));
  const auto [count, size, last] = begin;
  const std::uint64_t all = array.bytes * size_;
  if (size != block_size || count != (all + size - 1) / size || last != all % size) return false;
  const std::string sizes = decoded(array.text, sizeof(begin), (3 + count) * word);
  array.blocks.push_back(0);
  for (std::uint64_t b = 0; b < count; ++b) {
    std::uint64_t packed = 0;
    std::memcpy(&packed, sizes.data() + b * word, word);
    array.blocks.push_back(array.blocks.back() + packed);
  }
  array.text += static_cast<std::streamoff>(base64_size((3 + count) * word));
  return arrays_.emplace(name, std::move(array)).second;
}

/// True if the arrays have the types with which they are written; others are converted where a file is read at once.
bool RangedParticleReader::has_types() const {
  bool is_ours = arrays_.contains("Id") && arrays_.contains("Type");
  std::map<std::string, Array> further = arrays_;
  const auto expect = [&](const std::string& name, const std::string& type, std::size_t components) {
    const auto found = further.find(name);
    if (found == further.end()) return;
    is_ours = is_ours && found->second.type == type && found->second.components == components;
    further.erase(found);
  };
  for_each_array(frame_.set, [&](const char* name, const auto& array) {
    using T = typename std::remove_cvref_t<decltype(array)>::value_type;
    expect(name, type_of<T>(), std::is_same_v<T, Eigen::Vector3f> ? 3 : 1);
  });
  const Array& points = arrays_.at(array_of_points);
  is_ours = is_ours && points.components == 3 && (points.type == "Float32" || points.type == "Float64");
  further.erase(array_of_points);
  return is_ours && std::all_of(further.begin(), further.end(), [](const auto& named) {
           return named.second.type == "Float32" || named.second.type == "Float64";
         });
}

void RangedParticleReader::read_frame(const XmlElement& piece) {
  std::string head(piece.begin, '\0');
  stream_.seekg(0);
  stream_.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(head.rfind("<Piece"));
  head += no_particles;
  frame_ = read_particle_frame(file_, head, size_);
}

/// Bytes [from, to) of those that stand in base64 from `text` on.
std::string RangedParticleReader::decoded(std::streamoff text, std::uint64_t from, std::uint64_t to) {
  const std::uint64_t whole = from / 3 * 3;
  const std::uint64_t begin = whole / 3 * 4;
  std::string characters(base64_size(to) - begin, '\0');
  stream_.seekg(text + static_cast<std::streamoff>(begin));
  if (!stream_.read(characters.data(), static_cast<std::streamsize>(characters.size()))) {
    reject("announces more bytes than the file has", write_again);
  }
  std::string bytes(characters.size() / 4 * 3, '\0');
  const std::size_t read =
      vtkBase64Utilities::DecodeSafely(reinterpret_cast<const unsigned char*>(characters.data()), characters.size(),
                                       reinterpret_cast<unsigned char*>(bytes.data()), bytes.size());
  if (read < to - whole) reject("holds an array that is no base64 text", write_again);
  return bytes.substr(from - whole, to - from);
}

/// Bytes [from, to) of an array.
void RangedParticleReader::read_bytes(const Array& array, std::uint64_t from, std::uint64_t to, char* into) {
  std::string block(block_size, '\0');
  for (std::uint64_t b = from / block_size; b * block_size < to; ++b) {
    const std::uint64_t begin = b * block_size;
    const std::string packed = decoded(array.text, array.blocks[b], array.blocks[b + 1]);
    uLongf size = block.size();
    const int state = uncompress(reinterpret_cast<Bytef*>(block.data()), &size,
                                 reinterpret_cast<const Bytef*>(packed.data()), packed.size());
    if (state != Z_OK || size != std::min<std::uint64_t>(block_size, array.bytes * size_ - begin)) {
      reject("holds an array that cannot be decompressed", write_again);
    }
    const std::uint64_t first = std::max(from, begin);
    const std::uint64_t last = std::min(to, begin + size);
    std::memcpy(into + (first - from), block.data() + (first - begin), last - first);
  }
}

template <class T>
void RangedParticleReader::read(const std::string& name, std::uint64_t from, std::uint64_t to, std::vector<T>& into) {
  const auto found = arrays_.find(name);
  if (found == arrays_.end()) return;
  const Array& array = found->second;
  into.resize((to - from) * array.bytes / sizeof(T));
  read_bytes(array, from * array.bytes, to * array.bytes, reinterpret_cast<char*>(into.data()));
}

void RangedParticleReader::read_positions(std::uint64_t from, std::uint64_t to, std::vector<Vec3>& into) {
  if (arrays_.at(array_of_points).type == "Float64") return read(array_of_points, from, to, into);
  std::vector<Eigen::Vector3f> single;
  read(array_of_points, from, to, single);
  into.resize(single.size());
  std::transform(single.begin(), single.end(), into.begin(), [](const auto& x) { return x.template cast<double>(); });
}

/// Refuses what VTK takes.
void RangedParticleReader::check(std::uint64_t from, const ParticleSet& particles) const {
  const auto number = [&](std::size_t i) { return from + i; };
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (!particles.position[i].allFinite()) {
      reject(fmt::format("the position of particle {} is not finite", number(i)), write_again);
    }
    if (particles.position[i].cwiseAbs().maxCoeff() > farthest_place) {
      reject(fmt::format("particle {} lies more than {:g} m from the origin", number(i), farthest_place), write_again);
    }
  }
  const auto known = [&](const char* name, const auto& array) {
    const auto wrong = std::find_if(array.begin(), array.end(), [](auto word) { return static_cast<int>(word) > 3; });
    if (wrong == array.end()) return;
    reject(fmt::format("array {} holds {} at particle {}", name, static_cast<int>(*wrong),
                       number(static_cast<std::size_t>(wrong - array.begin()))),
           "it must be 0 to 3, see docs/file-formats.md");
  };
  known("Type", particles.type);
  known("State", particles.state);
}

ParticleSet RangedParticleReader::range(std::uint64_t from, std::uint64_t to) {
  ParticleSet particles = frame_.set;
  std::map<std::string, Array> further = arrays_;
  read_positions(from, to, particles.position);
  further.erase(array_of_points);
  for_each_array(particles, [&](const char* name, auto& array) {
    read(name, from, to, array);
    further.erase(name);
  });
  if (particles.mass.empty() && frame_.mass) particles.mass.assign(to - from, *frame_.mass);
  for (const auto& [name, array] : further) {
    if (array.type == "Float32") {
      read(name, from, to, particles.scalars[name]);
    } else {
      read(name, from, to, particles.doubles[name]);
    }
  }
  check(from, particles);
  return particles;
}

}  // namespace thalweg
