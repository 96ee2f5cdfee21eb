#include "solver/simulation/twin_search.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <tuple>

#include "common/particle_faults.hpp"
#include "solver/simulation/particle_messages.hpp"

namespace thalweg {
namespace {

/// Spreads numbers (the last step of splitmix64).
std::uint64_t spread(std::uint64_t n) {
  n = (n ^ (n >> 30)) * 0xbf58476d1ce4e5b9ULL;
  n = (n ^ (n >> 27)) * 0x94d049bb133111ebULL;
  return n ^ (n >> 31);
}

bool is_fluid(std::int64_t type) {
  return type == static_cast<std::int64_t>(ParticleType::water) ||
         type == static_cast<std::int64_t>(ParticleType::sediment);
}

template <class T>
void take(MessageReader& message, std::vector<T>& to) {
  const auto n = message.number<std::uint64_t>();
  to.resize(to.size() + n);
  message.read(to.data() + (to.size() - n), n);
}

template <class T>
void put(Bytes& message, const std::vector<T>& of) {
  const std::uint64_t n = of.size();
  append_to(message, &n, 1);
  append_to(message, of.data(), n);
}

}  // namespace

void TwinSearch::add(const ParticleSet& range) {
  const auto n = static_cast<std::size_t>(ranks_.size());
  std::vector<std::vector<std::int64_t>> ids(n);
  std::vector<std::vector<Placed>> places(n);
  for (std::size_t i = 0; i < range.size(); ++i) {
    const std::int64_t id = range.id[i];
    ids[spread(static_cast<std::uint64_t>(id)) % n].push_back(id);
    Placed placed{{}, id, static_cast<std::int64_t>(range.type[i])};
    std::uint64_t hash = 0;
    for (int c = 0; c < 3; ++c) {
      placed.at[c] = range.position[i][c] + 0.0;  // without -0, which is the same place
      hash = spread(hash + std::bit_cast<std::uint64_t>(placed.at[c]) + 0x9e3779b97f4a7c15ULL);
    }
    places[hash % n].push_back(placed);
  }
  std::vector<Bytes> messages(n);
  for (std::size_t r = 0; r < n && range.size() > 0; ++r) {
    put(messages[r], ids[r]);
    put(messages[r], places[r]);
  }
  const Bytes mine = scatter(ranks_, messages);
  if (mine.empty()) return;
  MessageReader message(mine);
  take(message, ids_);
  take(message, places_);
}

TwinSearch::Found TwinSearch::find() {
  Found found{};
  found.least = std::numeric_limits<std::int64_t>::max();
  std::sort(ids_.begin(), ids_.end());
  if (!ids_.empty()) found.least = ids_.front();
  if (const auto twin = std::adjacent_find(ids_.begin(), ids_.end()); twin != ids_.end()) {
    found.has_id = true;
    found.id = *twin;
  }
  const auto at = [](const Placed& p) { return std::tuple(p.at[0], p.at[1], p.at[2]); };
  std::sort(places_.begin(), places_.end(), [&](const Placed& a, const Placed& b) {
    return std::tuple_cat(at(a), std::tuple(a.id)) < std::tuple_cat(at(b), std::tuple(b.id));
  });
  for (std::size_t i = 1; i < places_.size() && !found.has_place; ++i) {
    const Placed& one = places_[i];
    const Placed& before = places_[i - 1];
    if (at(one) != at(before) || (!is_fluid(one.type) && !is_fluid(before.type))) continue;
    if (mixed_ && one.type != before.type) continue;
    found.has_place = true;
    found.placed = one;
    found.other = before.id;
  }
  ids_ = {};
  places_ = {};
  return found;
}

std::string TwinSearch::fault(const std::string& file) {
  const std::vector<Found> all = gather_from(ranks_, find());
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  const Found* twin = nullptr;
  const Found* place = nullptr;
  const auto at = [](const Found* f) { return std::tuple(f->placed.at[0], f->placed.at[1], f->placed.at[2]); };
  for (const Found& found : all) {
    least = std::min(least, found.least);
    if (found.has_id && (twin == nullptr || found.id < twin->id)) twin = &found;
    if (found.has_place && (place == nullptr || at(&found) < at(place))) place = &found;
  }
  if (least < 0) return fault_of_negative_id(file, least);
  if (twin != nullptr) return fault_of_two_with_an_id(file, twin->id);
  if (place == nullptr) return {};
  return fault_of_two_in_a_place(file, place->placed.id, Vec3(place->placed.at), place->other);
}

}  // namespace thalweg
