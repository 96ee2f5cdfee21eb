#include "tests/gencase/scene.hpp"

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "common/error.hpp"

namespace thalweg::gencase::test {

Case empty_scene(int dimension, double spacing) {
  Case scene;
  scene.file = "scene.toml";
  scene.info.name = "scene";
  scene.info.dimension = dimension;
  scene.domain.from = Vec3(-10, dimension == 2 ? 0 : -10, -10);
  scene.domain.to = Vec3(10, dimension == 2 ? 0 : 10, 10);
  scene.numerics.spacing = spacing;
  scene.output.end = 1;
  return scene;
}

namespace {

Shape& add(Case& scene, const std::string& name, ShapeKind kind, ShapeRole role) {
  Shape& shape = scene.shapes.emplace_back();
  shape.name = name;
  shape.kind = kind;
  shape.role = role;
  shape.line = 10 * static_cast<int>(scene.shapes.size());
  return shape;
}

}  // namespace

Shape& add_box(Case& scene, const std::string& name, ShapeRole role, const Vec3& from, const Vec3& to) {
  Shape& shape = add(scene, name, ShapeKind::box, role);
  shape.from = from;
  shape.to = to;
  return shape;
}

Shape& add_ball(Case& scene, const std::string& name, ShapeRole role, const Vec3& center, double radius) {
  Shape& shape = add(scene, name, ShapeKind::sphere, role);
  shape.center = center;
  shape.radius = radius;
  return shape;
}

Shape& add_cylinder(Case& scene, const std::string& name, ShapeRole role, const Vec3& from, const Vec3& to,
                    double radius) {
  Shape& shape = add(scene, name, ShapeKind::cylinder, role);
  shape.from = from;
  shape.to = to;
  shape.radius = radius;
  return shape;
}

Shape& add_combination(Case& scene, const std::string& name, ShapeKind kind, ShapeRole role,
                       const std::vector<std::string>& of) {
  Shape& shape = add(scene, name, kind, role);
  shape.of = of;
  return shape;
}

Shape& add_mesh(Case& scene, const std::string& name, ShapeRole role, const Triangles& surface) {
  static int files = 0;
  scene.folder = std::filesystem::temp_directory_path();
  const std::string file = "gencase_test_" + std::to_string(getpid()) + "_" + std::to_string(files++) + ".off";
  std::ofstream to(scene.folder / file);
  to.precision(17);
  to << "OFF\n" << surface.points.size() << ' ' << surface.corners.size() << " 0\n";
  for (const Vec3& p : surface.points) to << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  for (const auto& [a, b, c] : surface.corners) to << "3 " << a << ' ' << b << ' ' << c << '\n';
  Shape& shape = add(scene, name, ShapeKind::mesh, role);
  shape.file = file;
  return shape;
}

Triangles torus(double ring, double tube, int sides) {
  Triangles result;
  const auto n = static_cast<std::uint32_t>(sides);
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      const double around = 2 * M_PI * i / n;
      const double about = 2 * M_PI * j / n;
      const double arm = ring + tube * std::cos(about);
      result.points.emplace_back(arm * std::cos(around), arm * std::sin(around), tube * std::sin(about));
    }
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t a = i * n + j;
      const std::uint32_t b = (i + 1) % n * n + j;
      const std::uint32_t c = (i + 1) % n * n + (j + 1) % n;
      const std::uint32_t d = i * n + (j + 1) % n;
      result.corners.insert(result.corners.end(), {{a, b, c}, {a, c, d}});
    }
  return result;
}

Shape& add_tank(Case& scene, const Vec3& from, const Vec3& to) {
  Shape& shape = add_box(scene, "tank", ShapeRole::wall, from, to);
  shape.side = WallSide::outside;
  shape.open = {"+z"};
  return shape;
}

void add_sand(Case& scene) {
  SedimentParameters sand;
  sand.grain_density = 3000;
  sand.porosity = 0.5;
  sand.grain_diameter = 1e-3;
  sand.friction_angle = 0.6;
  scene.sediments["sand"] = sand;
  scene.model.sediment = SedimentModel::viscoplastic;
}

std::int64_t count(const ParticleSet& particles, ParticleType type) {
  return count_by_type(particles)[static_cast<std::size_t>(type)];
}

std::size_t nearest(const ParticleSet& particles, const Vec3& position) {
  std::size_t best = 0;
  for (std::size_t i = 0; i < particles.size(); ++i)
    if ((particles.position[i] - position).norm() < (particles.position[best] - position).norm()) best = i;
  return best;
}

std::string refusal(const Case& scene, double memory_limit) {
  GenerateOptions options;
  options.memory_limit = memory_limit;
  try {
    generate(scene, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace thalweg::gencase::test
