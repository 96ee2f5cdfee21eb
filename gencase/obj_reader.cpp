#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <sstream>

#include "common/error.hpp"
#include "gencase/text_meshes.hpp"
#include "gencase/words.hpp"

namespace thalweg::gencase {
namespace {

/// The lines of an OBJ file, each with those that a backslash joins to it, without comments.
class Lines {
 public:
  explicit Lines(const std::string& bytes) : text_(bytes) {}
  bool next(std::string& line) {
    line.clear();
    line_ = after_ + 1;
    std::string part;
    while (std::getline(text_, part)) {
      ++after_;
      part.erase(part.find_last_not_of(" \t\r") + 1);
      const bool goes_on = part.ends_with('\\');
      if (goes_on) part.pop_back();
      line += part + ' ';
      if (goes_on) continue;
      line.erase(std::min(line.find('#'), line.size()));
      return true;
    }
    return !line.empty();
  }
  [[nodiscard]] int line() const { return line_; }  // at which the joined line begins

 private:
  std::istringstream text_;
  int line_ = 0;
  int after_ = 0;
};

Vec3 point_of(const std::vector<std::string>& words, int line) {
  if (words.size() < 4)
    throw InputError(fmt::format("line {}: a point has {} coordinates; give three", line, words.size() - 1));
  Vec3 point;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto value = number_of<double>(words[k + 1]);
    if (!value || !std::isfinite(*value))
      throw InputError(
          fmt::format("line {}: \"{}\" is no number; correct it or export it again", line, shown(words[k + 1])));
    point[static_cast<Eigen::Index>(k)] = *value;
  }
  return point;
}

/// The points that a face names, counted from 0. Numbers below zero count back from the last point so far.
std::vector<std::size_t> corners_of(const std::vector<std::string>& words, std::size_t points, int line) {
  std::vector<std::size_t> corners;
  for (std::size_t k = 1; k < words.size(); ++k) {
    const std::string number = words[k].substr(0, words[k].find('/'));
    const auto named = number_of<std::int64_t>(number);
    const std::int64_t corner = !named ? 0 : (*named < 0 ? static_cast<std::int64_t>(points) + *named + 1 : *named);
    if (corner < 1)
      throw InputError(
          fmt::format("line {}: the face names the point \"{}\", which is none; export it again", line, shown(number)));
    corners.push_back(static_cast<std::size_t>(corner - 1));
  }
  return corners;
}

}  // namespace

MeshFile read_obj(const std::string& bytes) {
  MeshFile file;
  std::vector<int> lines_of_faces;
  std::size_t loose_lines = 0;
  std::size_t loose_points = 0;
  Lines lines(bytes);
  for (std::string line; lines.next(line);) {
    const std::vector<std::string> words = words_of(line);
    if (words.empty()) continue;
    loose_lines += words[0] == "l";
    loose_points += words[0] == "p";
    if (words[0] == "v") file.soup.points.push_back(point_of(words, lines.line()));
    if (words[0] != "f") continue;
    file.soup.polygons.push_back(corners_of(words, file.soup.points.size(), lines.line()));
    lines_of_faces.push_back(lines.line());
  }
  if (file.soup.polygons.empty())
    throw InputError("holds no line of a face (\"f 1 2 3\"); export the surface, not points alone");
  for (std::size_t face = 0; face < lines_of_faces.size(); ++face)
    for (const std::size_t corner : file.soup.polygons[face])
      if (corner >= file.soup.points.size())
        throw InputError(fmt::format("line {}: the face names point {} and there are {}; export it again",
                                     lines_of_faces[face], corner + 1, file.soup.points.size()));
  if (loose_lines + loose_points > 0)
    file.remarks.push_back(
        fmt::format("{} lines and {} points beside its faces are left out", loose_lines, loose_points));
  return file;
}

}  // namespace thalweg::gencase
