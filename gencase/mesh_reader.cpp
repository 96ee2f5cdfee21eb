#include "gencase/mesh_reader.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "common/error.hpp"
#include "gencase/ply_check.hpp"
#include "gencase/survey_reader.hpp"
#include "gencase/words.hpp"

namespace thalweg::gencase {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Points = std::vector<Kernel::Point_3>;

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";  // some editors begin a text with it

std::string contents_of(std::istream& from) {
  std::ostringstream text;
  text << from.rdbuf();
  return text.str();
}

/// The words of each line that has any, without comments.
std::vector<std::vector<std::string>> lines_of_words(const std::string& bytes) {
  std::istringstream text(bytes);
  std::vector<std::vector<std::string>> lines;
  for (std::string line; std::getline(text, line);) {
    line.erase(std::min(line.find('#'), line.size()));
    std::vector<std::string> words = words_of(line);
    if (!words.empty()) lines.push_back(std::move(words));
  }
  return lines;
}

/// The text of an OFF file as CGAL's reader may read it: the header as checked here, and of each point only its
/// coordinates. Fuzzing found three faults of that reader: it allocates memory for whatever number a header announces;
/// it misreads a header with a comment close to the word; and if the first point has colours and normals, it looks for
/// them in all points, beyond the end of shorter lines.
std::string checked_off(const std::string& bytes) {
  const auto lines = lines_of_words(bytes);
  // The word, then the numbers of points, faces and edges, on one line or several. The edges are often left away.
  std::vector<std::string> header;
  std::size_t line = 0;
  for (; header.size() < 3 && line < lines.size(); ++line)
    header.insert(header.end(), lines[line].begin(), lines[line].end());
  const bool known =
      !header.empty() && (header[0] == "OFF" || header[0] == "COFF" || header[0] == "NOFF" || header[0] == "CNOFF");
  if (!known || header.size() < 3 || header.size() > 4 || !is_count(header[1]) || !is_count(header[2]))
    throw InputError("is no OFF file: the word OFF and the counts of points and faces are missing; export it again");
  const auto size = static_cast<double>(bytes.size());
  check_count("points and faces", std::stod(header[1]) + std::stod(header[2]), size, 4);

  std::string plain = fmt::format("OFF\n{} {} 0\n", header[1], header[2]);
  const std::size_t faces = line + std::stoul(header[1]);
  for (; line < lines.size(); ++line) {
    const auto& words = lines[line];
    const std::size_t kept = line < faces ? std::min<std::size_t>(3, words.size()) : words.size();
    plain += fmt::format("{}\n", fmt::join(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(kept), " "));
    // The lines after the points hold numbers of corners, indices and colours: none is larger than the file's size.
    for (std::size_t i = 0; line >= faces && i < words.size(); ++i) {
      const std::string digits = words[i].substr(0, words[i].find_first_not_of("0123456789"));
      if (!digits.empty()) check_count("corners", is_count(digits) ? std::stod(digits) : HUGE_VAL, size, 1);
    }
  }
  return plain;
}

/// The bytes as CGAL's reader may read them. Throws InputError for those that are not of this format or damaged.
std::string checked(std::string bytes, MeshFormat format) {
  if (format == MeshFormat::off) return checked_off(bytes);
  check_ply(bytes);
  return bytes;
}

/// CGAL's readers do not tell why they cannot read something; the checks before and after find most.
PolygonSoup read_with_cgal(const std::string& unchecked, MeshFormat format) {
  const std::string bytes = checked(unchecked, format);
  std::istringstream from(bytes);
  const auto quiet = CGAL::parameters::verbose(false);
  Points points;
  PolygonSoup soup;
  bool read = false;
  try {
    read = format == MeshFormat::off ? CGAL::IO::read_OFF(from, points, soup.polygons, quiet)
                                     : CGAL::IO::read_PLY(from, points, soup.polygons, quiet);
  } catch (const std::exception&) {  // a length or count that no memory holds
    read = false;
  }
  if (!read)
    throw InputError(fmt::format(
        "cannot be read as {}: a number is missing or is none, or a face names a point that does not exist; export it "
        "again, or correct the extension",
        format == MeshFormat::off ? "OFF" : "PLY"));
  soup.points.reserve(points.size());
  for (const auto& p : points) soup.points.emplace_back(p.x(), p.y(), p.z());
  return soup;
}

void check_soup(const PolygonSoup& soup) {
  if (soup.polygons.empty()) throw InputError("holds no face; export the surface again");
  for (const Vec3& p : soup.points)
    if (!p.allFinite() || p.cwiseAbs().maxCoeff() > 1e15)
      throw InputError("has a coordinate that is no sensible number; export it again");
  for (const auto& polygon : soup.polygons) {
    if (polygon.size() < 3) throw InputError(fmt::format("has a face of {} corners; export it again", polygon.size()));
    for (const std::size_t corner : polygon)
      if (corner >= soup.points.size())
        throw InputError(fmt::format("has a face with the corner {} and only {} points; export it again", corner,
                                     soup.points.size()));
  }
}

/// True if a quadrilateral is better cut from its first to its third corner than from its second to its fourth: the cut
/// that makes no fold, otherwise the shorter one.
bool cut_first_to_third(const std::array<Vec3, 4>& p) {
  const auto fold = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {  // diagonal a-c
    return (p[b] - p[a]).cross(p[c] - p[a]).dot((p[c] - p[a]).cross(p[d] - p[a])) <= 0;
  };
  const bool first_folds = fold(0, 1, 2, 3);
  const bool second_folds = fold(1, 2, 3, 0);
  if (first_folds != second_folds) return second_folds;
  return (p[2] - p[0]).squaredNorm() <= (p[3] - p[1]).squaredNorm();
}

}  // namespace

MeshFile read_mesh(std::istream& from, MeshFormat format) {
  std::string bytes = contents_of(from);
  if (bytes.empty()) throw InputError("is empty; export it again");
  if (bytes.starts_with(byte_order_mark)) bytes.erase(0, byte_order_mark.size());
  MeshFile file;
  switch (format) {
    case MeshFormat::stl:
      file = read_stl(bytes);
      break;
    case MeshFormat::obj:
      file = read_obj(bytes);
      break;
    case MeshFormat::off:
    case MeshFormat::ply:
      file.soup = read_with_cgal(bytes, format);
      break;
  }
  check_soup(file.soup);
  return file;
}

MeshFile read_mesh(const std::filesystem::path& file) {
  static const std::map<std::string, MeshFormat> formats{
      {".stl", MeshFormat::stl}, {".obj", MeshFormat::obj}, {".off", MeshFormat::off}, {".ply", MeshFormat::ply}};
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (!std::filesystem::is_regular_file(file))
    throw InputError(file.string() + ": there is no such file; check the name, which is relative to the case's folder");
  const auto format = formats.find(extension);
  if (format == formats.end() && extension != ".vtp")
    throw InputError(
        is_survey(file)
            ? fmt::format("{}: holds points and no surface; write kind = \"bathymetry\" for it", file.string())
            : fmt::format("{}: meshes of the kind \"{}\" are not read; give .stl, .obj, .off, .ply or .vtp",
                          file.string(), extension));
  if (extension == ".vtp") {
    MeshFile read{read_vtp_surface(file), {}};
    try {
      check_soup(read.soup);
    } catch (const InputError& error) {
      throw InputError(file.string() + ": " + error.what());
    }
    return read;
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(file.string() + ": cannot be opened; check its permissions");
  try {
    return read_mesh(stream, format->second);
  } catch (const InputError& error) {
    throw InputError(file.string() + ": " + error.what());
  }
}

Triangles triangulate(const PolygonSoup& soup) {
  Triangles result;
  std::map<std::array<double, 3>, std::uint32_t> places;
  std::vector<std::uint32_t> place(soup.points.size());
  for (std::size_t i = 0; i < soup.points.size(); ++i) {
    const Vec3& p = soup.points[i];
    const auto [entry, fresh] = places.try_emplace({p.x(), p.y(), p.z()}, result.points.size());
    if (fresh) result.points.push_back(p);
    place[i] = entry->second;
  }
  for (const auto& polygon : soup.polygons) {
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      result.corners.push_back({place[polygon[a]], place[polygon[b]], place[polygon[c]]});
    };
    if (polygon.size() == 3) {
      add(0, 1, 2);
    } else if (polygon.size() == 4) {
      const bool first = cut_first_to_third(
          {soup.points[polygon[0]], soup.points[polygon[1]], soup.points[polygon[2]], soup.points[polygon[3]]});
      first ? (add(0, 1, 2), add(0, 2, 3)) : (add(0, 1, 3), add(1, 2, 3));
    } else {
      Points corners;
      for (const std::size_t corner : polygon)
        corners.emplace_back(soup.points[corner].x(), soup.points[corner].y(), soup.points[corner].z());
      std::vector<CGAL::Triple<int, int, int>> patch;
      CGAL::Polygon_mesh_processing::triangulate_hole_polyline(corners, std::back_inserter(patch));
      for (const auto& t : patch)
        add(static_cast<std::size_t>(t.first), static_cast<std::size_t>(t.second), static_cast<std::size_t>(t.third));
    }
  }
  return result;
}

}  // namespace thalweg::gencase
