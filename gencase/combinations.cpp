#include "gencase/combinations.hpp"

#include <algorithm>
#include <cmath>

#include "gencase/nearest_surface.hpp"

namespace thalweg::gencase {
namespace {

Bounds hull(const Bounds& a, const Bounds& b) { return {a.lower.cwiseMin(b.lower), a.upper.cwiseMax(b.upper)}; }

class Combination : public Region {
 public:
  explicit Combination(std::vector<RegionPointer> parts) : parts_(std::move(parts)) {}
  [[nodiscard]] std::optional<double> measure() const override { return std::nullopt; }
  void append_surfaces(std::vector<const Surface*>& surfaces) const override {
    for (const RegionPointer& part : parts_) part->append_surfaces(surfaces);
  }

 protected:
  std::vector<RegionPointer> parts_;
};

class Union : public Combination {
 public:
  using Combination::Combination;
  [[nodiscard]] bool contains(const Vec3& p) const override {
    return std::any_of(parts_.begin(), parts_.end(), [&](const RegionPointer& part) { return part->contains(p); });
  }
  [[nodiscard]] Bounds bounds() const override {
    Bounds result = parts_.front()->bounds();
    for (const RegionPointer& part : parts_) result = hull(result, part->bounds());
    return result;
  }
};

class Difference : public Combination {
 public:
  using Combination::Combination;
  [[nodiscard]] bool contains(const Vec3& p) const override {
    return parts_.front()->contains(p) &&
           std::none_of(parts_.begin() + 1, parts_.end(), [&](const RegionPointer& part) { return part->contains(p); });
  }
  [[nodiscard]] Bounds bounds() const override { return parts_.front()->bounds(); }
};

class Intersection : public Combination {
 public:
  using Combination::Combination;
  [[nodiscard]] bool contains(const Vec3& p) const override {
    return std::all_of(parts_.begin(), parts_.end(), [&](const RegionPointer& part) { return part->contains(p); });
  }
  [[nodiscard]] Bounds bounds() const override {
    Bounds result = parts_.front()->bounds();
    for (const RegionPointer& part : parts_) {
      const Bounds other = part->bounds();
      result.lower = result.lower.cwiseMax(other.lower);
      result.upper = result.upper.cwiseMin(other.upper);
    }
    result.upper = result.upper.cwiseMax(result.lower);  // parts apart: an empty box, not an inverted one
    return result;
  }
};

class Shell : public Region {
 public:
  Shell(RegionPointer inside, double thickness, int dimension)
      : inside_(std::move(inside)), thickness_(thickness), dimension_(dimension), nearest_(*inside_, thickness) {}
  [[nodiscard]] bool contains(const Vec3& p) const override {
    if (inside_->contains(p)) return false;
    const auto surface = nearest_.find(p, thickness_);
    return surface && surface->distance < thickness_;
  }
  [[nodiscard]] Bounds bounds() const override {
    Vec3 reach = Vec3::Constant(thickness_);
    if (dimension_ == 2) reach.y() = 0;
    const Bounds inner = inside_->bounds();
    return {inner.lower - reach, inner.upper + reach};
  }
  [[nodiscard]] std::optional<double> measure() const override { return std::nullopt; }
  void append_surfaces(std::vector<const Surface*>& surfaces) const override { inside_->append_surfaces(surfaces); }

 private:
  RegionPointer inside_;
  double thickness_;
  int dimension_;
  NearestSurface nearest_;
};

}  // namespace

RegionPointer make_union(std::vector<RegionPointer> parts) { return std::make_shared<Union>(std::move(parts)); }
RegionPointer make_difference(std::vector<RegionPointer> parts) {
  return std::make_shared<Difference>(std::move(parts));
}
RegionPointer make_intersection(std::vector<RegionPointer> parts) {
  return std::make_shared<Intersection>(std::move(parts));
}
RegionPointer make_shell(RegionPointer inside, double thickness, int dimension) {
  return std::make_shared<Shell>(std::move(inside), thickness, dimension);
}

}  // namespace thalweg::gencase
