#include "gencase/combinations.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gencase/nearest_surface.hpp"

namespace thalweg::gencase {
namespace {

Spans combined(const Spans& a, const Spans& b, Boolean how) {
  switch (how) {
    case Boolean::unite:
      return unite(a, b);
    case Boolean::subtract:
      return subtract(a, b);
    case Boolean::intersect:
      return intersect(a, b);
  }
  throw std::logic_error("an unknown way of combining spans");
}

Bounds hull(const Bounds& a, const Bounds& b) { return {a.lower.cwiseMin(b.lower), a.upper.cwiseMax(b.upper)}; }

class Combination : public Region {
 public:
  Combination(std::vector<RegionPointer> parts, Boolean how) : parts_(std::move(parts)), how_(how) {}
  [[nodiscard]] std::optional<double> measure() const override { return std::nullopt; }
  [[nodiscard]] Spans cut(const Line& line) const override {
    Spans spans = parts_.front()->cut(line);
    for (auto part = parts_.begin() + 1; part != parts_.end(); ++part)
      spans = combined(spans, (*part)->cut(line), how_);
    return spans;
  }
  [[nodiscard]] std::optional<Triangles> triangles(double deviation) const override {
    std::optional<Triangles> result = parts_.front()->triangles(deviation);
    for (auto part = parts_.begin() + 1; part != parts_.end() && result; ++part) {
      const std::optional<Triangles> other = (*part)->triangles(deviation);
      if (!other) return std::nullopt;
      result = combine(*result, *other, how_);
    }
    return result;
  }
  void append_surfaces(std::vector<const Surface*>& surfaces) const override {
    for (const RegionPointer& part : parts_) part->append_surfaces(surfaces);
  }

 protected:
  std::vector<RegionPointer> parts_;

 private:
  Boolean how_;
};

class Union : public Combination {
 public:
  explicit Union(std::vector<RegionPointer> parts) : Combination(std::move(parts), Boolean::unite) {}
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
  explicit Difference(std::vector<RegionPointer> parts) : Combination(std::move(parts), Boolean::subtract) {}
  [[nodiscard]] bool contains(const Vec3& p) const override {
    return parts_.front()->contains(p) &&
           std::none_of(parts_.begin() + 1, parts_.end(), [&](const RegionPointer& part) { return part->contains(p); });
  }
  [[nodiscard]] Bounds bounds() const override { return parts_.front()->bounds(); }
};

class Intersection : public Combination {
 public:
  explicit Intersection(std::vector<RegionPointer> parts) : Combination(std::move(parts), Boolean::intersect) {}
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
    result.upper = result.upper.cwiseMax(result.lower);  // parts without overlap: an empty box, not an inverted one
    return result;
  }
};

class Shell : public Region {
 public:
  Shell(RegionPointer inside, double thickness, int dimension)
      : inside_(std::move(inside)), thickness_(thickness), dimension_(dimension), nearest_(*inside_, thickness) {
    search_ = inside_->own_search() != nullptr ? inside_->own_search() : &nearest_;
  }
  [[nodiscard]] bool contains(const Vec3& p) const override {
    if (inside_->contains(p)) return false;
    const auto surface = search_->find(p, thickness_);
    return surface && surface->distance < thickness_;
  }
  [[nodiscard]] Bounds bounds() const override {
    Vec3 reach = Vec3::Constant(thickness_);
    if (dimension_ == 2) reach.y() = 0;
    const Bounds inner = inside_->bounds();
    return {inner.lower - reach, inner.upper + reach};
  }
  [[nodiscard]] std::optional<double> measure() const override { return std::nullopt; }
  [[nodiscard]] Spans cut(const Line& line) const override {
    const Bounds box = bounds();
    Spans near;
    for (std::int64_t node = first_node_from(line, box.lower[line.axis]); node < line.count;) {
      const double at = line.along(node);
      if (at > box.upper[line.axis]) break;
      const auto skin = search_->find(line.point(at), HUGE_VAL);
      if (!skin) break;
      if (skin->distance < thickness_) near.push_back({at, at});
      // The distance changes by at most a step from node to node, so these nodes lie beyond the thickness.
      const double idle = (skin->distance - thickness_) / line.step;
      node += std::max<std::int64_t>(1, static_cast<std::int64_t>(idle));
    }
    return subtract(near, inside_->cut(line));
  }
  [[nodiscard]] std::optional<Triangles> triangles(double) const override { return std::nullopt; }
  void append_surfaces(std::vector<const Surface*>& surfaces) const override { inside_->append_surfaces(surfaces); }

 private:
  RegionPointer inside_;
  double thickness_;
  int dimension_;
  NearestSurface nearest_;
  const SkinSearch* search_;
};

}  // namespace

RegionPointer make_union(std::vector<RegionPointer> parts) { return std::make_shared<Union>(std::move(parts)); }
RegionPointer make_difference(std::vector<RegionPointer> parts) {
  return std::make_shared<Difference>(std::move(parts));
}
RegionPointer make_intersection(std::vector<RegionPointer> parts) {
  return std::make_shared<Intersection>(std::move(parts));
}
RegionPointer make_combination(std::vector<RegionPointer> parts, Boolean how) {
  switch (how) {
    case Boolean::unite:
      return make_union(std::move(parts));
    case Boolean::subtract:
      return make_difference(std::move(parts));
    case Boolean::intersect:
      return make_intersection(std::move(parts));
  }
  throw std::logic_error("an unknown way of combining regions");
}
RegionPointer make_shell(RegionPointer inside, double thickness, int dimension) {
  return std::make_shared<Shell>(std::move(inside), thickness, dimension);
}

}  // namespace thalweg::gencase
