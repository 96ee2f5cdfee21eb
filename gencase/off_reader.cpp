#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "common/error.hpp"
#include "gencase/text_meshes.hpp"
#include "gencase/words.hpp"

// Own code, because CGAL's reader trusts what it reads: fuzzing it found memory for any number that a header announces,
// reads beyond the ends of short lines, and coordinates taken for a number of corners after a line that is too short.
namespace thalweg::gencase {
namespace {

struct WordsOfLine {
  int number;
  std::vector<std::string> words;
};

/// The lines that have words, without comments.
std::vector<WordsOfLine> lines_of(const std::string& bytes) {
  std::istringstream text(bytes);
  std::vector<WordsOfLine> lines;
  int number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    line.erase(std::min(line.find('#'), line.size()));
    std::vector<std::string> words = words_of(line);
    if (!words.empty()) lines.push_back({number, std::move(words)});
  }
  return lines;
}

struct Counts {
  std::size_t points;
  std::size_t faces;
  std::size_t lines;  // that the head takes
};

/// The word, then the numbers of points, faces and edges, on one line or several. The edges are often left away.
Counts counts_of(const std::vector<WordsOfLine>& lines, std::size_t size) {
  std::vector<std::string> head;
  std::size_t used = 0;
  for (; head.size() < 3 && used < lines.size(); ++used)
    head.insert(head.end(), lines[used].words.begin(), lines[used].words.end());
  const bool known =
      !head.empty() && (head[0] == "OFF" || head[0] == "COFF" || head[0] == "NOFF" || head[0] == "CNOFF");
  if (!known || head.size() < 3 || head.size() > 4 || !is_count(head[1]) || !is_count(head[2]))
    throw InputError("is no OFF file: the word OFF and the counts of points and faces are missing; export it again");
  const auto points = number_of<std::size_t>(head[1]).value_or(0);
  const auto faces = number_of<std::size_t>(head[2]).value_or(0);
  check_count("points and faces", static_cast<double>(points + faces), static_cast<double>(size), 4);
  if (points + faces > lines.size() - used)
    throw InputError(
        fmt::format("announces {} points and faces and has {} lines after that: it is cut off; export it "
                    "again",
                    points + faces, lines.size() - used));
  return {points, faces, used};
}

/// The coordinates; normals, colours and texture may follow them.
Vec3 corner_of(const WordsOfLine& line) {
  if (line.words.size() < 3)
    throw InputError(fmt::format("line {}: a point has {} coordinates; give three", line.number, line.words.size()));
  Vec3 point;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto value = number_of<double>(line.words[k]);
    if (!value || !std::isfinite(*value))
      throw InputError(fmt::format("line {}: \"{}\" is no number; correct it or export it again", line.number,
                                   shown(line.words[k])));
    point[static_cast<Eigen::Index>(k)] = *value;
  }
  return point;
}

/// A number of corners, so many points, and perhaps a colour.
std::vector<std::size_t> face_of(const WordsOfLine& line, std::size_t points) {
  const std::size_t count = is_count(line.words[0]) ? number_of<std::size_t>(line.words[0]).value_or(0) : 0;
  if (count == 0 || count >= line.words.size())
    throw InputError(
        fmt::format("line {}: the face begins with \"{}\" and {} words follow; begin it with the number of "
                    "its corners",
                    line.number, shown(line.words[0]), line.words.size() - 1));
  std::vector<std::size_t> corners;
  for (std::size_t k = 1; k <= count; ++k) {
    const auto corner = number_of<std::size_t>(line.words[k]);
    if (!corner || *corner >= points)
      throw InputError(fmt::format("line {}: the face names point {} and the points are 0 to {}; export it again",
                                   line.number, shown(line.words[k]), static_cast<double>(points) - 1));
    corners.push_back(*corner);
  }
  return corners;
}

}  // namespace

MeshFile read_off(const std::string& bytes) {
  const std::vector<WordsOfLine> lines = lines_of(bytes);
  const Counts counts = counts_of(lines, bytes.size());
  MeshFile file;
  const auto first = lines.begin() + static_cast<std::ptrdiff_t>(counts.lines);
  const auto faces = first + static_cast<std::ptrdiff_t>(counts.points);
  std::transform(first, faces, std::back_inserter(file.soup.points), corner_of);
  std::transform(faces, faces + static_cast<std::ptrdiff_t>(counts.faces), std::back_inserter(file.soup.polygons),
                 [&](const WordsOfLine& line) { return face_of(line, counts.points); });
  return file;
}

}  // namespace thalweg::gencase
