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
#include "common/plain_file.hpp"
#include "gencase/ply_check.hpp"
#include "gencase/survey_reader.hpp"
#include "gencase/text_meshes.hpp"

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

/// CGAL's reader does not tell why it cannot read something; the checks before and after find most.
PolygonSoup read_ply(const std::string& bytes) {
  check_ply(bytes);
  std::istringstream from(bytes);
  Points points;
  PolygonSoup soup;
  bool read = false;
  try {
    read = CGAL::IO::read_PLY(from, points, soup.polygons, CGAL::parameters::verbose(false));
  } catch (const std::exception&) {  // a length or count that no memory holds
    read = false;
  }
  if (!read)
    throw InputError(
        "cannot be read as PLY: a number is missing or is none, or a face names a point that does not exist; export it "
        "again, or correct the extension");
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
      file = read_off(bytes);
      break;
    case MeshFormat::ply:
      file.soup = read_ply(bytes);
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
  require_plain_file(file, "a mesh");
  if (!std::filesystem::exists(file))
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
