#include "gencase/closure.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <deque>
#include <vector>

namespace thalweg::gencase {
namespace {

class Flood {
 public:
  Flood(const Case& scene, const std::vector<PlacedShape>& shapes, const FlowRoom& room, const Filling& filling)
      : scene_(scene), shapes_(shapes), room_(room), filling_(filling), lattice_(filling.lattice) {
    up_ = lattice_.axes[2];
    rises_ = scene.domain.gravity[up_] <= 0;
    top_ = rises_ ? -1 : lattice_.count[up_];
    // The direction (0 to 5) in which the flood reached each node, plus one; 0: not reached; 7: a fluid particle.
    came_.assign(static_cast<std::size_t>(lattice_.nodes()), 0);
    for (std::int64_t node = 0; node < lattice_.nodes(); ++node) {
      if (!is_fluid(node)) continue;
      came_[static_cast<std::size_t>(node)] = source;
      const std::int64_t height = node % lattice_.column_length();
      top_ = rises_ ? std::max(top_, height) : std::min(top_, height);
    }
  }

  std::optional<Leak> run() {
    for (const std::vector<std::int64_t>& slab : find_boundary_nodes())
      for (const std::int64_t node : slab)
        for (unsigned char direction = 0; direction < 6; ++direction)
          if (auto leak = step(node, lattice_.offset(node), direction)) return leak;
    for (; !front_.empty(); front_.pop_front()) {
      const std::int64_t node = front_.front();
      const Index3 at = lattice_.offset(node);
      for (unsigned char direction = 0; direction < 6; ++direction)
        if (auto leak = step(node, at, direction)) return leak;
    }
    return std::nullopt;
  }

 private:
  static constexpr unsigned char source = 7;

  /// Fluid nodes with a neighbour that is neither fluid nor wall, in the order of the lattice, one list for each slab.
  [[nodiscard]] std::vector<std::vector<std::int64_t>> find_boundary_nodes() const {
    const std::int64_t length = lattice_.column_length();
    const std::int64_t columns_of_slab = lattice_.count[lattice_.axes[1]];
    std::vector<std::vector<std::int64_t>> nodes(static_cast<std::size_t>(lattice_.count[lattice_.axes[0]]));
    tbb::parallel_for(std::size_t{0}, nodes.size(), [&](std::size_t slab) {
      const std::int64_t begin = static_cast<std::int64_t>(slab) * columns_of_slab;
      for (std::int64_t column = begin; column < begin + columns_of_slab; ++column) {
        Index3 at = lattice_.offset(column * length);
        for (at[up_] = 0; at[up_] < length; ++at[up_]) {
          const std::int64_t node = column * length + at[up_];
          if (came_[static_cast<std::size_t>(node)] == source && borders_free_space(node, at))
            nodes[slab].push_back(node);
        }
      }
    });
    return nodes;
  }
  [[nodiscard]] bool borders_free_space(std::int64_t node, const Index3& at) const {
    std::int64_t stride = 1;
    for (int place = 2; place >= 0; stride *= lattice_.count[lattice_.axes[place--]]) {
      const int axis = lattice_.axes[place];
      if (lattice_.dimension == 2 && axis == 1) continue;
      if (at[axis] == 0 || at[axis] + 1 == lattice_.count[axis]) return true;
      for (const std::int64_t beside : {node - stride, node + stride})
        if (came_[static_cast<std::size_t>(beside)] == 0 && !is_wall(beside)) return true;
    }
    return false;
  }

  [[nodiscard]] bool is_fluid(std::int64_t node) const {
    const Label label = filling_.label[static_cast<std::size_t>(node)];
    return label != nothing && label != solid_core && shapes_[label - 1U].is_fluid();
  }
  [[nodiscard]] bool is_wall(std::int64_t node) const {
    const Label label = filling_.label[static_cast<std::size_t>(node)];
    return label == solid_core || (label != nothing && shapes_[label - 1U].is_wall());
  }

  static Index3 moved(Index3 at, unsigned char direction) {
    at[direction / 2] += direction % 2 == 0 ? 1 : -1;
    return at;
  }

  std::optional<Leak> step(std::int64_t node, const Index3& at, unsigned char direction) {
    const int axis = direction / 2;
    if (lattice_.dimension == 2 && axis == 1) return std::nullopt;
    const Index3 to = moved(at, direction);
    if (axis == up_ && (rises_ ? to[up_] > top_ : to[up_] < top_)) return std::nullopt;
    const bool left_lattice = to[axis] < 0 || to[axis] >= lattice_.count[axis];
    if (!left_lattice && (came_[static_cast<std::size_t>(lattice_.flat(to))] != 0 || is_wall(lattice_.flat(to))))
      return std::nullopt;
    const Vec3 place = lattice_.position(to);
    const bool left_domain = place[axis] < scene_.domain.from[axis] || place[axis] > scene_.domain.to[axis];
    if (left_domain && scene_.domain.is_periodic(axis)) return std::nullopt;
    const bool left = left_lattice || left_domain;
    if (left && room_.inside_containers(place)) return std::nullopt;  // through an open face
    if (left || !room_.inside_rooms(place)) return Leak{path_to(node, place), room_.has_rooms()};
    came_[static_cast<std::size_t>(lattice_.flat(to))] = static_cast<unsigned char>(direction + 1);
    front_.push_back(lattice_.flat(to));
    return std::nullopt;
  }

  [[nodiscard]] std::vector<Vec3> path_to(std::int64_t node, const Vec3& end) const {
    std::vector<Vec3> path{end};
    for (;;) {
      const Index3 at = lattice_.offset(node);
      path.push_back(lattice_.position(at));
      const unsigned char came = came_[static_cast<std::size_t>(node)];
      if (came == source) break;
      node = lattice_.flat(moved(at, static_cast<unsigned char>((came - 1) ^ 1)));
    }
    std::reverse(path.begin(), path.end());
    return path;
  }

  const Case& scene_;
  const std::vector<PlacedShape>& shapes_;
  const FlowRoom& room_;
  const Filling& filling_;
  const Lattice& lattice_;
  int up_ = 2;
  bool rises_ = true;
  std::int64_t top_ = 0;
  std::vector<unsigned char> came_;
  std::deque<std::int64_t> front_;
};

}  // namespace

std::optional<Leak> find_leak(const Case& scene, const std::vector<PlacedShape>& shapes, const FlowRoom& room,
                              const Filling& filling) {
  // Fluid without any wall, such as a falling drop, cannot leak.
  if (std::none_of(shapes.begin(), shapes.end(), [](const PlacedShape& shape) { return shape.is_wall(); }))
    return std::nullopt;
  return Flood(scene, shapes, room, filling).run();
}

}  // namespace thalweg::gencase
