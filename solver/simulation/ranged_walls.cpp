#include "solver/simulation/ranged_walls.hpp"

#include <map>
#include <string>
#include <variant>
#include <vector>

#include "solver/models/moving_walls/arrays.hpp"
#include "solver/models/wall_stress/find_elements.hpp"
#include "solver/simulation/checkpoint.hpp"

namespace thalweg {
namespace {

bool is_wall(ParticleType type) { return type == ParticleType::wall || type == ParticleType::moving_wall; }

/// Adds the numbers of particle i, if there are any: `each` a particle.
template <class T>
void take(const std::map<std::string, std::vector<T>>& from, const char* name, std::size_t each, std::size_t i,
          std::map<std::string, std::vector<T>>& to) {
  const auto found = from.find(name);
  if (found == from.end()) return;
  const auto begin = found->second.begin() + static_cast<std::ptrdiff_t>(each * i);
  std::vector<T>& numbers = to[name];
  numbers.insert(numbers.end(), begin, begin + static_cast<std::ptrdiff_t>(each));
}

}  // namespace

void RangedWalls::add(const ParticleSet& range) {
  if (range.doubles.contains(field::wall_element.name)) return;
  for (std::size_t i = 0; i < range.size(); ++i) {
    if (!is_wall(range.type[i])) continue;
    walls_.id.push_back(range.id[i]);
    walls_.type.push_back(range.type[i]);
    walls_.position.push_back(range.position[i]);
    take(range.scalars, motion_array, 1, i, walls_.scalars);
    take(range.scalars, roughness_array, 1, i, walls_.scalars);
    take(range.doubles, field::moved_from.name, 3, i, walls_.doubles);
  }
}

void RangedWalls::find(const AnyScene& any) {
  std::visit(
      [&]<int Dim>(const Scene<Dim>& scene) {
        if (scene.wall_stress.on && walls_.size() > 0) elements_ = WallElementFinder<Dim>(scene, walls_).find();
      },
      any);
  walls_ = {};
}

void RangedWalls::give(ParticleSet& range) {
  if (elements_.empty()) return;
  constexpr std::size_t each = numbers_in<WallElement>();
  std::vector<double>& numbers = range.doubles[field::wall_element.name];
  numbers.resize(each * range.size());
  for (std::size_t i = 0; i < range.size(); ++i) {
    encode(is_wall(range.type[i]) ? elements_[next_++] : WallElement{}, &numbers[each * i]);
  }
}

}  // namespace thalweg
