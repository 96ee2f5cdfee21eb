#include "gencase/mesh_reader.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

#include "common/error.hpp"
#include "gencase/ply_check.hpp"
#include "gencase/words.hpp"

namespace thalweg::gencase {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Points = std::vector<Kernel::Point_3>;
using Polygons = std::vector<std::vector<std::size_t>>;

std::string contents_of(std::istream& from) {
  std::ostringstream text;
  text << from.rdbuf();
  return text.str();
}

/// Refuses a file that announces more elements than its bytes can hold, before a reader allocates memory for them.
/// `least` [bytes] is the size of the smallest element of the format.
void check_count(const std::string& what, double announced, double bytes, double least) {
  if (announced >= 0 && announced * least <= bytes) return;
  throw InputError(fmt::format("announces {:.6g} {} and has only {} bytes: it is cut off or damaged; export it again",
                               announced, what, static_cast<std::int64_t>(bytes)));
}

bool is_text_stl(const std::string& bytes) {
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
  return begin != std::string::npos && bytes.compare(begin, 5, "solid") == 0 &&
         bytes.find("facet") != std::string::npos;
}

void check_stl(const std::string& bytes) {
  if (is_text_stl(bytes)) {
    if (bytes.find("endsolid") == std::string::npos)
      throw InputError("ends before its \"endsolid\": it is cut off; export it again");
    return;
  }
  if (bytes.size() < 84) throw InputError("is too short for an STL file; export it again");
  std::uint32_t facets = 0;
  std::memcpy(&facets, bytes.data() + 80, 4);
  check_count("facets", facets, static_cast<double>(bytes.size()) - 84, 50);
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

void check_obj(const std::string& bytes) {
  if (bytes.starts_with("f ") || bytes.find("\nf ") != std::string::npos) return;
  throw InputError("holds no line of a face (\"f 1 2 3\"); export the surface, not points alone");
}

/// The bytes as CGAL's reader may read them. Throws InputError for those that are not of this format or damaged.
std::string checked(std::string bytes, MeshFormat format) {
  if (bytes.empty()) throw InputError("is empty; export it again");
  switch (format) {
    case MeshFormat::stl:
      check_stl(bytes);
      break;
    case MeshFormat::obj:
      check_obj(bytes);
      break;
    case MeshFormat::off:
      return checked_off(bytes);
    case MeshFormat::ply:
      check_ply(bytes);
      break;
  }
  return bytes;
}

const char* name_of(MeshFormat format) {
  switch (format) {
    case MeshFormat::stl:
      return "STL";
    case MeshFormat::obj:
      return "OBJ";
    case MeshFormat::off:
      return "OFF";
    case MeshFormat::ply:
      return "PLY";
  }
  return "";
}

/// False if the bytes cannot be read. CGAL's readers do not tell the reason; the checks before and after find most.
bool read_with_cgal(const std::string& bytes, MeshFormat format, Points& points, Polygons& polygons) {
  std::istringstream from(bytes);
  const auto quiet = CGAL::parameters::verbose(false);
  switch (format) {
    case MeshFormat::stl:
      return CGAL::IO::read_STL(from, points, polygons, quiet);
    case MeshFormat::obj:
      return CGAL::IO::read_OBJ(from, points, polygons, quiet);
    case MeshFormat::off:
      return CGAL::IO::read_OFF(from, points, polygons, quiet);
    case MeshFormat::ply:
      return CGAL::IO::read_PLY(from, points, polygons, quiet);
  }
  return false;
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

PolygonSoup read_mesh(std::istream& from, MeshFormat format) {
  const std::string bytes = checked(contents_of(from), format);
  Points points;
  PolygonSoup soup;
  bool read = false;
  try {
    read = read_with_cgal(bytes, format, points, soup.polygons);
  } catch (const std::exception&) {  // a length or count that no memory holds
    read = false;
  }
  if (!read)
    throw InputError(fmt::format(
        "cannot be read as {}: a number is missing or is none, or a face names a point that does not exist; export it "
        "again, or correct the extension",
        name_of(format)));
  soup.points.reserve(points.size());
  for (const auto& p : points) soup.points.emplace_back(p.x(), p.y(), p.z());
  check_soup(soup);
  return soup;
}

PolygonSoup read_mesh(const std::filesystem::path& file) {
  static const std::map<std::string, MeshFormat> formats{
      {".stl", MeshFormat::stl}, {".obj", MeshFormat::obj}, {".off", MeshFormat::off}, {".ply", MeshFormat::ply}};
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (!std::filesystem::is_regular_file(file))
    throw InputError(file.string() + ": there is no such file; check the name, which is relative to the case's folder");
  if (extension == ".vtp") {
    const PolygonSoup soup = read_vtp_surface(file);
    try {
      check_soup(soup);
    } catch (const InputError& error) {
      throw InputError(file.string() + ": " + error.what());
    }
    return soup;
  }
  const auto format = formats.find(extension);
  if (format == formats.end())
    throw InputError(fmt::format("{}: meshes of the kind \"{}\" are not read; give .stl, .obj, .off, .ply or .vtp",
                                 file.string(), extension));
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
