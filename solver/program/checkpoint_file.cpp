#include "solver/program/checkpoint_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "common/error.hpp"
#include "common/io/file_seal.hpp"
#include "common/io/particle_file.hpp"
#include "common/particle_arrays.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

constexpr const char* case_fact = "Case";
constexpr const char* arrays_fact = "Arrays";
constexpr const char* counts_fact = "RunCounts";

/// Every array of a set with the number of its entries, a line each.
std::string array_list(const ParticleSet& particles) {
  std::ostringstream list;
  const auto add = [&](const std::string& name, std::size_t entries) {
    if (entries > 0) list << name << ' ' << entries << '\n';
  };
  add("Position", particles.position.size());
  for_each_array(particles, [&](const char* name, const auto& values) { add(name, values.size()); });
  for (const auto& [name, values] : particles.scalars) add(name, values.size());
  for (const auto& [name, values] : particles.doubles) add(name, values.size());
  for (const auto& [name, values] : particles.facts) add(name, values.size());
  return list.str();
}

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
  const auto counts = numbers_of(checkpoint.counts);
  particles.facts[counts_fact].assign(counts.begin(), counts.end());
  const std::map<std::string, std::string> texts{{case_fact, checkpoint.case_text},
                                                 {arrays_fact, array_list(particles)}};
  write_particles(run.checkpoint(), particles, PositionPrecision::double_precision, texts,
                  {.previous = run.previous_checkpoint(), .make_folders = false});
}

Checkpoint read_checkpoint(const fs::path& file) {
  if (!fs::is_regular_file(file)) {
    throw InputError(fmt::format("{}: there is no such checkpoint; name one, or say --restart latest", file.string()));
  }
  if (seal_state(file) != SealState::whole) reject(file, "is damaged, cut off, or no checkpoint");
  std::map<std::string, std::string> texts;
  Checkpoint checkpoint;
  checkpoint.particles = read_particles(file, &texts);
  if (!texts.contains(case_fact) || !texts.contains(arrays_fact)) {
    reject(file, "is no checkpoint: a snapshot or a filled scene does not hold the whole state");
  }
  const std::string found = array_list(checkpoint.particles);
  if (found != texts[arrays_fact]) {
    reject(file, "is incomplete: it should hold " + first_difference(texts[arrays_fact], found));
  }
  checkpoint.case_text = texts[case_fact];
  const auto counts = checkpoint.particles.facts.extract(counts_fact);
  if (counts.empty() || counts.mapped().size() != numbers_in_counts) reject(file, "is incomplete: it lacks RunCounts");
  std::array<double, numbers_in_counts> numbers{};
  std::copy(counts.mapped().begin(), counts.mapped().end(), numbers.begin());
  checkpoint.counts = counts_of(numbers);
  return checkpoint;
}

}  // namespace thalweg
