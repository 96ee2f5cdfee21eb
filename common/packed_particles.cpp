#include "common/packed_particles.hpp"

#include <zlib.h>

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "common/particle_arrays.hpp"
#include "common/particle_extremes.hpp"

namespace thalweg {
namespace {

constexpr int compression_level = 1;

template <class T>
std::string_view bytes_of(const std::vector<T>& array) {
  return {reinterpret_cast<const char*>(array.data()), std::span(array).size_bytes()};
}

BlockCutter::Sink into(std::vector<BlockPiece>& pieces) {
  return [&pieces](BlockPiece piece) { pieces.push_back(std::move(piece)); };
}

}  // namespace

std::string compressed_block(std::string_view block) {
  std::string compressed(compressBound(block.size()), '\0');
  uLongf size = compressed.size();
  compress2(reinterpret_cast<Bytef*>(compressed.data()), &size, reinterpret_cast<const Bytef*>(block.data()),
            block.size(), compression_level);
  compressed.resize(size);
  return compressed;
}

void BlockCutter::hand_over(std::string_view part, const Sink& sink) {
  const bool is_whole = part.size() == block_size;
  sink({at_ / block_size, at_ % block_size, is_whole, is_whole ? compressed_block(part) : std::string(part)});
  at_ += part.size();
}

void BlockCutter::add(std::string_view bytes, const Sink& sink) {
  while (!bytes.empty()) {
    const std::size_t missing = block_size - (at_ + pending_.size()) % block_size;
    const std::string_view next = bytes.substr(0, missing);
    bytes.remove_prefix(next.size());
    if (next.size() == block_size) {
      hand_over(next, sink);
      continue;
    }
    pending_.append(next);
    if (next.size() == missing) end(sink);
  }
}

void BlockCutter::end(const Sink& sink) {
  if (!pending_.empty()) hand_over(std::exchange(pending_, {}), sink);
}

void ParticlePacker::add_bytes(const std::string& array, std::string_view bytes, std::size_t of_particles,
                               PackedRange& to) {
  if (bytes.empty()) return;
  const std::uint64_t begin = begin_ * (bytes.size() / of_particles);
  cutters_.try_emplace(array, begin).first->second.add(bytes, into(to.pieces[array]));
}

void ParticlePacker::add_points(const std::vector<Vec3>& points, PackedRange& to) {
  if (precision_ == PositionPrecision::double_precision) {
    return add_bytes(array_of_points, bytes_of(points), points.size(), to);
  }
  std::vector<Eigen::Vector3f> single(points.size());
  std::transform(points.begin(), points.end(), single.begin(), [](const Vec3& x) { return x.cast<float>(); });
  add_bytes(array_of_points, bytes_of(single), single.size(), to);
}

/// One vertex a particle (io/particle_writer.cpp).
void ParticlePacker::add_vertices(std::size_t n, PackedRange& to) {
  std::vector<std::int64_t> numbers(n);
  std::iota(numbers.begin(), numbers.end(), static_cast<std::int64_t>(begin_));
  add_bytes(array_of_vertices, bytes_of(numbers), n, to);
  for (std::int64_t& number : numbers) ++number;
  add_bytes(array_of_offsets, bytes_of(numbers), n, to);
}

PackedRange ParticlePacker::add(const ParticleSet& range) {
  PackedRange packed;
  const std::size_t n = range.size();
  if (n == 0) return packed;
  packed.particles = n;
  if (precision_ == PositionPrecision::double_precision) {
    widen(packed.extremes, range);
  } else {
    // The file's range is that of the numbers it holds.
    ParticleSet rounded = range;
    for (Vec3& x : rounded.position) x = x.cast<float>().cast<double>();
    widen(packed.extremes, rounded);
  }
  for_each_array(range, [&](const char* name, const auto& array) { add_bytes(name, bytes_of(array), n, packed); });
  for (const auto& [name, array] : range.scalars) add_bytes(name, bytes_of(array), n, packed);
  for (const auto& [name, array] : range.doubles) add_bytes(name, bytes_of(array), n, packed);
  add_points(range.position, packed);
  add_vertices(n, packed);
  begin_ += n;
  return packed;
}

PackedRange ParticlePacker::end() {
  PackedRange left;
  for (auto& [name, cutter] : cutters_) cutter.end(into(left.pieces[name]));
  return left;
}

}  // namespace thalweg
