#include "solver/program/checkpoint_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include "common/error.hpp"
#include "common/io/file_seal.hpp"
#include "common/io/particle_file.hpp"
#include "common/io/ranged_particle_reader.hpp"
#include "common/particle_arrays.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

constexpr const char* case_fact = "Case";
constexpr const char* arrays_fact = "Arrays";
constexpr const char* counts_fact = "RunCounts";

/// Every array with the number of its entries, a line each, and every fact: of `total` particles, of which the set has
/// some at least.
std::string array_list(const ParticleSet& particles, const std::map<std::string, std::vector<double>>& facts,
                       std::size_t total) {
  std::ostringstream list;
  const auto add_numbers = [&](const std::string& name, std::size_t entries) {
    if (entries > 0) list << name << ' ' << entries << '\n';
  };
  const auto add = [&](const std::string& name, std::size_t entries) {
    if (entries > 0) add_numbers(name, entries / particles.size() * total);
  };
  add("Position", particles.position.size());
  for_each_array(particles, [&](const char* name, const auto& values) { add(name, values.size()); });
  for (const auto& [name, values] : particles.scalars) add(name, values.size());
  for (const auto& [name, values] : particles.doubles) add(name, values.size());
  for (const auto& [name, values] : facts) add_numbers(name, values.size());
  return list.str();
}

void add_counts(std::map<std::string, std::vector<double>>& facts, const RunCounts& counts) {
  const auto numbers = numbers_of(counts);
  facts[counts_fact].assign(numbers.begin(), numbers.end());
}

WholeFile way_of(const RunFolder& run) { return {.previous = run.previous_checkpoint(), .make_folders = false}; }

/// The first line of a list that the other does not have.
std::string first_difference(const std::string& wanted, const std::string& found) {
  std::istringstream lines(wanted);
  for (std::string line; std::getline(lines, line);) {
    if (("\n" + found).find("\n" + line + "\n") == std::string::npos) return line;
  }
  return "an array that it should not have";
}

[[noreturn]] void reject(const fs::path& file, const std::string& what) {
  throw InputError(
      fmt::format("{}: {}; take the checkpoint before it (--restart latest does), or start anew with "
                  "--force",
                  file.string(), what));
}

}  // namespace

void write_checkpoint(const RunFolder& run, Checkpoint checkpoint) {
  ParticleSet& particles = checkpoint.particles;
  add_counts(particles.facts, checkpoint.counts);
  const std::map<std::string, std::string> texts{
      {case_fact, checkpoint.case_text}, {arrays_fact, array_list(particles, particles.facts, particles.size())}};
  write_particles(run.checkpoint(), particles, PositionPrecision::double_precision, texts, way_of(run));
}

std::unique_ptr<RangedParticleFile> begin_checkpoint(const RunFolder& run) {
  return std::make_unique<RangedParticleFile>(run.checkpoint(), way_of(run));
}

void finish_checkpoint(RangedParticleFile& file, ParticleFileFrame frame, const std::string& case_text,
                       const RunCounts& counts) {
  add_counts(frame.facts, counts);
  frame.texts = {{case_fact, case_text},
                 {arrays_fact, array_list(file.extremes(), frame.facts, static_cast<std::size_t>(file.size()))}};
  file.finish(frame);
}

namespace {

void require_whole(const fs::path& file) {
  if (!fs::is_regular_file(file)) {
    throw InputError(fmt::format("{}: there is no such checkpoint; name one, or say --restart latest", file.string()));
  }
  if (seal_state(file) != SealState::whole) reject(file, "is damaged, cut off, or no checkpoint");
}

/// A checkpoint of `total` particles, of which it has some at least. Refuses one that lacks something.
Checkpoint complete(const fs::path& file, ParticleSet particles, const std::map<std::string, std::string>& texts,
                    std::size_t total) {
  if (!texts.contains(case_fact) || !texts.contains(arrays_fact)) {
    reject(file, "is no checkpoint: a snapshot or a filled scene does not hold the whole state");
  }
  const std::string found = array_list(particles, particles.facts, total);
  if (found != texts.at(arrays_fact)) {
    reject(file, "is incomplete: it should hold " + first_difference(texts.at(arrays_fact), found));
  }
  Checkpoint checkpoint{std::move(particles), texts.at(case_fact), {}};
  const auto counts = checkpoint.particles.facts.extract(counts_fact);
  if (counts.empty() || counts.mapped().size() != numbers_in_counts) reject(file, "is incomplete: it lacks RunCounts");
  std::array<double, numbers_in_counts> numbers{};
  std::copy(counts.mapped().begin(), counts.mapped().end(), numbers.begin());
  checkpoint.counts = counts_of(numbers);
  return checkpoint;
}

}  // namespace

Checkpoint read_checkpoint(const fs::path& file) {
  require_whole(file);
  std::map<std::string, std::string> texts;
  ParticleSet particles = read_particles(file, &texts);
  const std::size_t total = particles.size();
  return complete(file, std::move(particles), texts, total);
}

Checkpoint open_checkpoint(const fs::path& file, std::unique_ptr<ParticleSource>& source) {
  require_whole(file);
  auto reader = RangedParticleReader::open(file);
  if (!reader) return read_checkpoint(file);
  Checkpoint checkpoint = complete(file, reader->range(0, 1), reader->texts(), reader->size());
  ParticleSet frame;
  frame.info = checkpoint.particles.info;
  frame.facts = checkpoint.particles.facts;
  checkpoint.particles = std::move(frame);
  source = std::make_unique<RangedParticleReader>(std::move(*reader));
  return checkpoint;
}

}  // namespace thalweg
