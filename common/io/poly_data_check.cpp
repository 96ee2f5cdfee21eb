#include "common/io/poly_data_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <set>
#include <string>

#include "common/error.hpp"
#include "common/io/file_seal.hpp"
#include "common/io/stored_array.hpp"
#include "common/shown.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

// The arrays of particle files unpack to 8 times the file's size; surfaces and constants to less than 20 times.
constexpr std::uint64_t largest_growth = 40;
constexpr std::uint64_t always_allowed = std::uint64_t{1} << 26;  // [bytes]

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream) throw InputError(file.string() + ": cannot be opened; check the name and the permissions");
  std::string bytes(static_cast<std::size_t>(stream.tellg()), '\0');
  stream.seekg(0);
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return bytes;
}

/// True for a file whose contents are as they were written.
bool has_whole_seal(std::string_view bytes) {
  const std::size_t mark = bytes.rfind("<!-- crc32 ");
  return mark != std::string_view::npos && bytes.substr(mark) == seal_of(bytes.substr(0, mark));
}

class Checker {
 public:
  Checker(const fs::path& path, std::string_view bytes)
      : root_(parse_xml(bytes, path, "AppendedData")), file_{path, bytes}, sealed_(has_whole_seal(bytes)) {}

  void check() {
    head();
    const XmlElement* content = nullptr;
    for (const XmlElement& child : root_.children) {
      if (child.name == "PolyData" && content == nullptr) {
        content = &child;
      } else if (child.name == "AppendedData") {
        appended(child);
      } else {
        file_.refuse(child, fmt::format("a <{}> has no place here", shown(child.name)));
      }
    }
    if (content == nullptr) file_.refuse(root_, "holds no PolyData", "save it as PolyData (.vtp)");
    if (content->attributes.contains("TimeValues"))
      file_.refuse(*content, "holds several times", "write one file each");
    for (const XmlElement& child : content->children) {
      if (child.name == "FieldData") {
        field_data(child);
      } else if (child.name == "Piece") {
        piece(child);
      } else {
        file_.refuse(child, fmt::format("a <{}> has no place here", shown(child.name)));
      }
    }
  }

 private:
  void head() {
    const std::string type = root_.attribute("type");
    if (root_.name != "VTKFile" || type != "PolyData") {
      file_.refuse(root_, root_.name != "VTKFile" ? "is no file of VTK" : fmt::format("holds a {}", shown(type)),
                   "save it as PolyData (.vtp)");
    }
    const std::string order = root_.attribute("byte_order");
    file_.big_endian = order == "BigEndian";
    if (!file_.big_endian && order != "LittleEndian") {
      file_.refuse(root_, fmt::format("has the unknown byte order \"{}\"", shown(order)));
    }
    const std::string header = root_.attribute("header_type");
    if (!header.empty() && header != "UInt32" && header != "UInt64") {
      file_.refuse(root_, fmt::format("has the unknown header type \"{}\"", shown(header)));
    }
    file_.word = header == "UInt64" ? 8 : 4;
    file_.compressor = root_.attribute("compressor");
    constexpr std::array known{"", "vtkZLibDataCompressor", "vtkLZ4DataCompressor", "vtkLZMADataCompressor"};
    if (std::find(known.begin(), known.end(), file_.compressor) == known.end()) {
      file_.refuse(root_, fmt::format("is compressed with the unknown \"{}\"", shown(file_.compressor)));
    }
  }

  // The data begin behind an underscore.
  void appended(const XmlElement& element) {
    const std::string encoding = element.attribute("encoding");
    if (encoding != "raw" && encoding != "base64") {
      file_.refuse(element, fmt::format("appended data have the unknown encoding \"{}\"", shown(encoding)));
    }
    file_.appended_is_base64 = encoding == "base64";
    const std::size_t mark = file_.bytes.find_first_not_of(" \t\r\n", std::min(element.begin, file_.bytes.size()));
    if (mark == std::string_view::npos || file_.bytes[mark] != '_') {
      file_.refuse(element, "appended data do not begin with an underscore");
    }
    file_.appended = mark + 1;
  }

  [[nodiscard]] std::uint64_t number(const XmlElement& element, const char* name, std::uint64_t otherwise,
                                     std::uint64_t most) const {
    if (!element.attributes.contains(name)) return otherwise;
    const std::string text = element.attribute(name);
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || value > most) {
      file_.refuse(element, fmt::format("{}=\"{}\" is no number from 0 to {}", name, shown(text), most));
    }
    return value;
  }

  /// Reads an array's header, and checks what stands beside its numbers.
  StoredArray array(const XmlElement& element) {
    if (element.name != "DataArray" && element.name != "Array") {
      file_.refuse(element, fmt::format("a <{}> has no place here", shown(element.name)));
    }
    if (element.attributes.contains("TimeStep")) file_.refuse(element, "holds several times", "write one file each");
    constexpr std::uint64_t most_words = 16;  // of a vector that describes an array
    for (const XmlElement& key : element.children) (void)number(key, "length", 0, most_words);
    if ((element.attribute("type") == "String") != (element.name == "Array")) {
      file_.refuse(element,
                   fmt::format("texts stand in <Array>, numbers in <DataArray>; this is a <{}>", element.name));
    }
    StoredArray stored(file_, element);
    unpacked_ += stored.size();
    if (unpacked_ > always_allowed + largest_growth * file_.bytes.size()) {
      file_.refuse(element, fmt::format("the arrays announce {} bytes, more than {} times the file's size", unpacked_,
                                        largest_growth));
    }
    if (!sealed_) stored.check_contents();  // VTK 9.1 crashes while it reports an array that it cannot decompress
    return stored;
  }

  /// An array with so many entries of `components` numbers each.
  void sized(const XmlElement& element, const StoredArray& stored, std::uint64_t entries) const {
    constexpr std::uint64_t most_components = 1000;
    const std::uint64_t components = number(element, "NumberOfComponents", 1, most_components);
    if (components == 0) file_.refuse(element, fmt::format("the array \"{}\" has no components", shown(stored.name())));
    std::uint64_t count = stored.count();
    if (stored.is_text_array()) {  // texts end with a zero
      const auto characters = stored.integers();
      count = static_cast<std::uint64_t>(std::count(characters.begin(), characters.end(), 0));
    }
    if (count % components == 0 && count / components == entries) return;
    file_.refuse(element, fmt::format("the array \"{}\" holds {} numbers; it needs {} times {}", shown(stored.name()),
                                      count, entries, components));
  }

  void named(const XmlElement& element, std::set<std::string>& names) const {
    const std::string name = element.attribute("Name");
    if (name.empty()) file_.refuse(element, "an array has no name");
    if (!names.insert(name).second) file_.refuse(element, fmt::format("two arrays are named \"{}\"", shown(name)));
  }

  void field_data(const XmlElement& fields) {
    std::set<std::string> names;
    for (const XmlElement& element : fields.children) {
      named(element, names);
      const StoredArray stored = array(element);
      if (!stored.is_finite()) {  // VTK loses the facts that follow
        file_.refuse(element, fmt::format("{} in the field data is no finite number", shown(stored.name())));
      }
      sized(element, stored, number(element, "NumberOfTuples", 0, most_entries));
    }
  }

  void attributes(const XmlElement& data, std::uint64_t entries) {
    std::set<std::string> names;
    for (const XmlElement& element : data.children) {
      named(element, names);
      sized(element, array(element), entries);
    }
  }

  void piece(const XmlElement& piece) {
    const std::uint64_t points = number(piece, "NumberOfPoints", 0, most_entries);
    constexpr std::array kinds{"Verts", "Lines", "Strips", "Polys"};
    std::uint64_t all_cells = 0;
    for (const char* kind : kinds) all_cells += number(piece, fmt::format("NumberOf{}", kind).c_str(), 0, most_entries);
    std::set<std::string> seen;
    for (const XmlElement& part : piece.children) {
      if (!seen.insert(part.name).second) file_.refuse(part, fmt::format("a second <{}>", shown(part.name)));
      if (part.name == "PointData") {
        attributes(part, points);
      } else if (part.name == "CellData") {
        attributes(part, all_cells);
      } else if (part.name == "Points") {
        coordinates(part, points);
      } else if (std::find(kinds.begin(), kinds.end(), part.name) != kinds.end()) {
        cells(part, number(piece, ("NumberOf" + part.name).c_str(), 0, most_entries), points);
      } else {
        file_.refuse(part, fmt::format("a <{}> has no place here", shown(part.name)));
      }
    }
    if (points > 0 && !seen.contains("Points"))
      file_.refuse(piece, fmt::format("announces {} points, holds none", points));
    for (const char* kind : kinds) {
      if (seen.contains(kind) || number(piece, fmt::format("NumberOf{}", kind).c_str(), 0, most_entries) == 0) continue;
      file_.refuse(piece, fmt::format("announces {}, holds none", kind));
    }
  }

  void coordinates(const XmlElement& part, std::uint64_t points) {
    if (points == 0 && part.children.empty()) return;
    if (part.children.size() != 1) file_.refuse(part, fmt::format("needs one array, has {}", part.children.size()));
    const XmlElement& element = part.children.front();
    if (element.attribute("NumberOfComponents") != "3" || element.name != "DataArray") {
      file_.refuse(element, "points need three coordinates each");
    }
    sized(element, array(element), points);
  }

  /// The corners of all cells one after the other, and for each cell where its corners end.
  void cells(const XmlElement& part, std::uint64_t count, std::uint64_t points) {
    const XmlElement* corners_at = nullptr;
    const XmlElement* ends_at = nullptr;
    for (const XmlElement& element : part.children) {
      const std::string name = element.attribute("Name");
      const XmlElement** const found = name == "connectivity" ? &corners_at : &ends_at;
      if (*found != nullptr || (name != "connectivity" && name != "offsets")) {
        file_.refuse(element, fmt::format("<{}> needs the arrays connectivity and offsets once", part.name));
      }
      *found = &element;
    }
    if (count == 0 && part.children.empty()) return;
    if (corners_at == nullptr || ends_at == nullptr) {
      file_.refuse(part, fmt::format("<{}> needs the arrays connectivity and offsets", part.name));
    }
    const std::vector<std::int64_t> ends = array(*ends_at).integers();
    const std::vector<std::int64_t> corners = array(*corners_at).integers();
    if (ends.size() != count) {
      file_.refuse(*ends_at, fmt::format("{} cells announced, {} there", count, ends.size()));
    }
    std::int64_t last = 0;
    for (const std::int64_t end : ends) {
      if (end < last) file_.refuse(*ends_at, "offsets do not rise");
      last = end;
    }
    if (static_cast<std::uint64_t>(last) != corners.size()) {
      file_.refuse(*corners_at, fmt::format("the cells have {} corners, {} are there", last, corners.size()));
    }
    for (const std::int64_t corner : corners) {
      if (corner >= 0 && static_cast<std::uint64_t>(corner) < points) continue;
      file_.refuse(*corners_at, fmt::format("a corner is point {}, and there are {} points", corner, points));
    }
  }

  static constexpr std::uint64_t most_entries = std::uint64_t{1} << 40;

  XmlElement root_;
  VtkFile file_;
  bool sealed_;
  std::uint64_t unpacked_ = 0;  // [bytes] of all arrays so far
};

}  // namespace

void check_poly_data(const fs::path& file, std::string_view text) { Checker(file, text).check(); }

void check_poly_data(const fs::path& file) { check_poly_data(file, bytes_of(file)); }

}  // namespace thalweg
