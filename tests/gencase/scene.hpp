#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"
#include "gencase/generate.hpp"
#include "gencase/region.hpp"

namespace thalweg::gencase::test {

/// A case "scene.toml" with a wide domain, h = 1.5 spacing and nothing in it; shapes get the lines 10, 20, 30 …
Case empty_scene(int dimension, double spacing);

Shape& add_box(Case& scene, const std::string& name, ShapeRole role, const Vec3& from, const Vec3& to);
Shape& add_ball(Case& scene, const std::string& name, ShapeRole role, const Vec3& center, double radius);
Shape& add_cylinder(Case& scene, const std::string& name, ShapeRole role, const Vec3& from, const Vec3& to,
                    double radius);
Shape& add_combination(Case& scene, const std::string& name, ShapeKind kind, ShapeRole role,
                       const std::vector<std::string>& of);
/// A mesh shape; its surface goes into a file of this process.
Shape& add_mesh(Case& scene, const std::string& name, ShapeRole role, const Triangles& surface);
/// A torus around the z axis through the origin; radii of its middle circle and of its tube [m].
Triangles torus(double ring, double tube, int sides);
/// A container open at the top.
Shape& add_tank(Case& scene, const Vec3& from, const Vec3& to);
/// Saturated sand of 2000 kg/m^3: half grains of 3000, half water.
void add_sand(Case& scene);

std::int64_t count(const ParticleSet& particles, ParticleType type);

/// Index of the particle nearest to `position`.
std::size_t nearest(const ParticleSet& particles, const Vec3& position);

/// The message with which a scene is refused, or "accepted".
std::string refusal(const Case& scene, double memory_limit = 1e12);

}  // namespace thalweg::gencase::test
