#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "common/error.hpp"
#include "gencase/text_meshes.hpp"
#include "gencase/words.hpp"

namespace thalweg::gencase {
namespace {

constexpr std::size_t bytes_before_facets =
    84;                            // [bytes] before the facets of a binary file: a name of 80 and their number
constexpr std::size_t facet = 50;  // [bytes] twelve numbers of four bytes, two bytes of attributes

std::uint32_t announced_facets(const std::string& bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + bytes_before_facets - sizeof(count), sizeof(count));
  return count;
}

PolygonSoup read_binary(const std::string& bytes) {
  const std::size_t count = announced_facets(bytes);
  PolygonSoup soup;
  soup.points.reserve(3 * count);
  soup.polygons.reserve(count);
  for (std::size_t f = 0; f < count; ++f) {
    for (std::size_t corner = 1; corner <= 3; ++corner) {  // the normal comes first
      std::array<float, 3> place{};
      std::memcpy(place.data(), bytes.data() + bytes_before_facets + f * facet + corner * sizeof(place), sizeof(place));
      soup.points.emplace_back(place[0], place[1], place[2]);
    }
    soup.polygons.push_back({3 * f, 3 * f + 1, 3 * f + 2});
  }
  return soup;
}

std::string small_letters(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

/// The words of a text, one after the other, with their lines.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}
  /// The next word as it is written; empty at the end.
  std::string_view next() {
    while (at_ < text_.size() && is_blank(text_[at_])) line_ += text_[at_++] == '\n';
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_blank(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }
  void skip_line() { at_ = std::min(text_.find('\n', at_), text_.size()); }
  [[nodiscard]] int line() const { return line_; }

 private:
  static bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }
  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
};

Vec3 next_point(Words& words) {
  Vec3 point;
  for (double& coordinate : point) {
    const std::string_view word = words.next();
    const auto value = number_of<double>(word);
    if (word.empty()) throw InputError("ends before its \"endsolid\": it is cut off; export it again");
    if (!value)
      throw InputError(
          fmt::format("line {}: \"{}\" is no number; correct it or export it again", words.line(), shown(word)));
    coordinate = *value;
  }
  return point;
}

/// Names of solids may hold any word, so the rest of such a line is passed over.
MeshFile read_text(std::string_view text) {
  MeshFile file;
  Words words(text);
  std::vector<std::size_t> corners;
  bool in_facet = false;
  bool ended = false;
  for (std::string word = small_letters(words.next()); !word.empty(); word = small_letters(words.next())) {
    if (word == "end") word += small_letters(words.next());
    if (word == "solid" || word == "endsolid") {
      ended = word == "endsolid";
      words.skip_line();
    } else if (word == "facet") {
      in_facet = true;
      corners.clear();
    } else if (word == "vertex") {
      file.soup.points.push_back(next_point(words));
      corners.push_back(file.soup.points.size() - 1);
    } else if (word == "endfacet") {
      if (!in_facet || corners.size() < 3)
        throw InputError(
            fmt::format("line {}: a facet of {} corners ends here; export it again", words.line(), corners.size()));
      file.soup.polygons.push_back(corners);
      in_facet = false;
    }
  }
  if (in_facet) throw InputError("ends before its \"endsolid\": it is cut off; export it again");
  if (!ended) file.remarks.emplace_back("its last line \"endsolid\" is missing, all of its facets are whole");
  return file;
}

}  // namespace

void check_count(const std::string& what, double announced, double bytes, double least) {
  if (announced >= 0 && announced * least <= bytes) return;
  throw InputError(fmt::format("announces {:.6g} {} and has only {} bytes: it is cut off or damaged; export it again",
                               announced, what, static_cast<std::int64_t>(bytes)));
}

MeshFile read_stl(const std::string& bytes) {
  const bool has_head = bytes.size() >= bytes_before_facets;
  if (has_head && bytes.size() == bytes_before_facets + facet * announced_facets(bytes))
    return {read_binary(bytes), {}};
  const std::string_view text(bytes);
  const std::string beginning = small_letters(text.substr(0, 1000));
  const std::size_t first = beginning.find_first_not_of(" \t\r\n");
  const bool is_text = first != std::string::npos && beginning.compare(first, 5, "solid") == 0 &&
                       beginning.find('\0') == std::string::npos;
  if (is_text) return read_text(text);
  if (!has_head) throw InputError("is too short for an STL file; export it again");
  check_count("facets", announced_facets(bytes), static_cast<double>(bytes.size() - bytes_before_facets), facet);
  return {read_binary(bytes), {"bytes behind its last facet are left out"}};
}

}  // namespace thalweg::gencase
