#include "solver/simulation/packed_share.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "solver/simulation/particle_messages.hpp"

namespace thalweg {
namespace {

std::uint64_t ranges_in(std::uint64_t particles) {
  return (particles + PackedShare::at_once - 1) / PackedShare::at_once;
}

void append_text(Bytes& message, const std::string& text) {
  const std::uint64_t size = text.size();
  append_to(message, &size, 1);
  append_to(message, text.data(), size);
}
std::string text_in(MessageReader& message) {
  std::string text(message.number<std::uint64_t>(), '\0');
  message.read(text.data(), text.size());
  return text;
}

}  // namespace

PackedShare::PackedShare(OwnRanges& own, Ranks& ranks, FileContents of, double spacing) : own_(own), of_(of) {
  frame_.facts = own.facts_of(of);
  const std::vector<OwnRanges::Counts> counts = gather_from(ranks, own.counts());
  const auto rank = static_cast<std::size_t>(ranks.rank());
  std::uint64_t fluid = 0;
  std::uint64_t fluid_before = 0;
  std::uint64_t walls_before = 0;
  double farthest = 0;
  for (std::size_t r = 0; r < counts.size(); ++r) {
    const std::uint64_t walls = counts[r].all - counts[r].fluid;
    fluid += counts[r].fluid;
    fluid_before += r < rank ? counts[r].fluid : 0;
    walls_before += r < rank ? walls : 0;
    farthest = std::max(farthest, counts[r].farthest);
    rounds_ = std::max(rounds_, ranges_in(counts[r].fluid) + ranges_in(walls));
  }
  frame_.precision = of == FileContents::full_state
                         ? PositionPrecision::double_precision
                         : sufficient_precision(PositionPrecision::single_precision, farthest, spacing);
  const OwnRanges::Counts& mine = counts[rank];
  parts_.push_back({0, mine.fluid, ParticlePacker(fluid_before, frame_.precision)});
  parts_.push_back({mine.fluid, mine.all, ParticlePacker(fluid + walls_before, frame_.precision)});
}

PackedRange PackedShare::next() {
  const auto part = std::find_if(parts_.begin(), parts_.end(), [](const Part& of) { return of.from < of.to; });
  if (part == parts_.end()) return {};
  const std::uint64_t to = std::min(part->to, part->from + at_once);
  PackedRange packed = part->packer.add(own_.range(of_, part->from, to));
  part->from = to;
  if (to < part->to) return packed;
  for (auto& [name, pieces] : part->packer.end().pieces) {
    std::move(pieces.begin(), pieces.end(), std::back_inserter(packed.pieces[name]));
  }
  return packed;
}

Bytes to_message(const PackedRange& range) {
  Bytes message;
  append_to(message, &range.particles, 1);
  append_to(message, range.extremes);
  const std::uint64_t arrays = range.pieces.size();
  append_to(message, &arrays, 1);
  for (const auto& [name, pieces] : range.pieces) {
    append_text(message, name);
    const std::uint64_t n = pieces.size();
    append_to(message, &n, 1);
    for (const BlockPiece& piece : pieces) {
      const std::uint64_t numbers[] = {piece.block, piece.at, piece.is_compressed ? std::uint64_t{1} : 0};
      append_to(message, numbers, 3);
      append_text(message, piece.bytes);
    }
  }
  return message;
}

PackedRange packed_range_in(const Bytes& bytes) {
  MessageReader message(bytes);
  PackedRange range;
  range.particles = message.number<std::uint64_t>();
  range.extremes = particles_in(message);
  for (auto arrays = message.number<std::uint64_t>(); arrays > 0; --arrays) {
    std::vector<BlockPiece>& pieces = range.pieces[text_in(message)];
    for (auto n = message.number<std::uint64_t>(); n > 0; --n) {
      BlockPiece& piece = pieces.emplace_back();
      piece.block = message.number<std::uint64_t>();
      piece.at = message.number<std::uint64_t>();
      piece.is_compressed = message.number<std::uint64_t>() != 0;
      piece.bytes = text_in(message);
    }
  }
  return range;
}

}  // namespace thalweg
