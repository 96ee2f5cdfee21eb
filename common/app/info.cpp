#include "common/app/info.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "case/reader/case_file.hpp"
#include "common/csv.hpp"
#include "common/error.hpp"
#include "common/io/particle_file.hpp"
#include "common/io/series.hpp"
#include "common/memory.hpp"
#include "common/particle_words.hpp"
#include "common/run_folder.hpp"
#include "common/units.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

std::string megabytes(double bytes) { return fmt::format("{:.3g} MB", bytes / 1e6); }

template <class T>
double bytes_of(const std::vector<T>& array) {
  return static_cast<double>(array.size() * sizeof(T));
}

double memory_of(const ParticleSet& p) {
  double bytes = bytes_of(p.id) + bytes_of(p.type) + bytes_of(p.state) + bytes_of(p.position) + bytes_of(p.velocity) +
                 bytes_of(p.density) + bytes_of(p.pressure) + bytes_of(p.mass) + bytes_of(p.viscosity) +
                 bytes_of(p.normal);
  for (const auto& [name, values] : p.scalars) bytes += bytes_of(values);
  for (const auto& [name, values] : p.doubles) bytes += bytes_of(values);
  return bytes;
}

void print_types(std::ostream& to, const ParticleSet& p) {
  const auto counts = count_by_type(p);
  const auto masses = mass_by_type(p);
  const bool plane = p.info.dimension == 2;
  const char* unit = plane ? "kg/m" : "kg";
  const double cell = std::pow(p.info.spacing, p.info.dimension);  // volume of a particle at the start
  for (std::size_t type = 0; type < counts.size(); ++type) {
    if (counts[type] == 0) continue;
    fmt::print(to, "  {:<12}{:>12}", type_words[type], counts[type]);
    fmt::print(to, "  {:.6g} {}", static_cast<double>(counts[type]) * cell, plane ? "m^2" : "m^3");
    if (!p.mass.empty()) fmt::print(to, "  {:.6g} {}", masses[type], unit);
    fmt::print(to, "\n");
  }
  fmt::print(to, "  {:<12}{:>12}\n", "all", p.size());
  if (p.state.empty()) return;
  std::array<std::int64_t, 4> states{};
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.type[i] == ParticleType::sediment) ++states[static_cast<std::size_t>(p.state[i])];
  }
  for (std::size_t state = 1; state < states.size(); ++state) {
    if (states[state] > 0) fmt::print(to, "  sediment, {}: {}\n", state_words[state], states[state]);
  }
}

template <class T>
void print_range(std::ostream& to, const char* name, const std::vector<T>& values, const char* unit) {
  if (values.empty()) return;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  fmt::print(to, "  {} {:.6g} to {:.6g} {}\n", name, *low, *high, unit);
}

void print_particles(std::ostream& to, const fs::path& file) {
  const ParticleSet p = read_particles(file);
  fmt::print(to, "{}: {} particles of case \"{}\", {}-D, {} on disk\n", file.string(), p.size(), p.info.case_name,
             p.info.dimension, megabytes(static_cast<double>(fs::file_size(file))));
  fmt::print(to, "  time {:.6g} s, step {}, spacing {}, smoothing length {}\n", p.info.time, p.info.step,
             format_quantity(p.info.spacing, "m"), format_quantity(p.info.smoothing_length, "m"));
  fmt::print(to, "  written by Thalweg {}, case hash {}\n", p.info.code_version, p.info.case_hash);
  print_types(to, p);
  if (p.size() == 0) return;
  Vec3 low = p.position.front();
  Vec3 high = low;
  for (const Vec3& position : p.position) {
    low = low.cwiseMin(position);
    high = high.cwiseMax(position);
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (axis == 1 && p.info.dimension == 2) continue;
    fmt::print(to, "  {} from {:.6g} m to {:.6g} m\n", "xyz"[axis], low[axis], high[axis]);
  }
  std::vector<float> speed(p.velocity.size());
  std::transform(p.velocity.begin(), p.velocity.end(), speed.begin(),
                 [](const auto& velocity) { return velocity.norm(); });
  print_range(to, "speed", speed, "m/s");
  print_range(to, "density", p.density, "kg/m^3");
  print_range(to, "pressure", p.pressure, "Pa");
  std::vector<std::string> further;
  for (const auto& [name, values] : p.scalars) further.push_back(name);
  for (const auto& [name, values] : p.doubles) further.push_back(name);
  if (!further.empty()) fmt::print(to, "  further arrays: {}\n", fmt::join(further, ", "));
  fmt::print(to, "  memory of these arrays: {}\n", megabytes(memory_of(p)));
  const MemoryEstimate memory = estimate_memory(static_cast<double>(p.size()), p.info.dimension);
  fmt::print(to, "  memory of the solver: about {} on a CPU; {} of a GPU's and {} of the host's\n",
             format_bytes(memory.total()), format_bytes(memory.gpu), format_bytes(memory.host));
}

void print_series(std::ostream& to, const fs::path& pvd) {
  const std::vector<SeriesEntry> entries = read_series(pvd);
  fmt::print(to, "{}: {} snapshots", pvd.string(), entries.size());
  if (!entries.empty()) fmt::print(to, ", {:.6g} s to {:.6g} s", entries.front().time, entries.back().time);
  const auto absent = std::count_if(entries.begin(), entries.end(), [&](const SeriesEntry& entry) {
    return !fs::exists(pvd.parent_path() / entry.file);
  });
  if (absent > 0) fmt::print(to, "; {} of the files are missing", absent);
  fmt::print(to, "\n");
}

void print_case(std::ostream& to, const fs::path& file) {
  const Case resolved = read_case(file);
  fmt::print(to, "{}: case \"{}\", {}-D, to {:.6g} s; hash {}\n", file.string(), resolved.info.name,
             resolved.info.dimension, resolved.output.end, hash_of(resolved));
  if (!resolved.info.title.empty()) fmt::print(to, "  {}\n", resolved.info.title);
}

void print_summary(std::ostream& to, const fs::path& file) {
  const CsvTable table = CsvTable::read(file);
  const auto names = table.texts("quantity");
  const auto values = table.texts("value");
  const auto units = table.texts("unit");
  fmt::print(to, "{}:\n", file.string());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    fmt::print(to, "  {} {}{}{}\n", names[row], values[row], units[row].empty() || units[row] == "-" ? "" : " ",
               units[row] == "-" ? "" : units[row]);
  }
}

void print_run(std::ostream& to, const RunFolder& run) {
  bool found = false;
  const auto print_if_there = [&](const fs::path& file, void (*print)(std::ostream&, const fs::path&)) {
    if (!fs::exists(file)) return;
    print(to, file);
    found = true;
  };
  print_if_there(run.resolved_case(), print_case);
  print_if_there(run.particles(), print_particles);
  print_if_there(run.snapshot_series(), print_series);
  print_if_there(run.checkpoint(), print_particles);
  print_if_there(run.summary(), print_summary);
  if (!found) {
    throw InputError(
        fmt::format("{}: the folder holds no run; name one that thalweg gencase has filled", run.root.string()));
  }
}

}  // namespace

void print_info(std::ostream& to, const fs::path& file_or_folder) {
  if (fs::is_directory(file_or_folder)) return print_run(to, RunFolder{file_or_folder});
  if (!fs::exists(file_or_folder)) {
    throw InputError(fmt::format("{}: there is no such file or folder; check the name", file_or_folder.string()));
  }
  if (file_or_folder.extension() == ".pvd") return print_series(to, file_or_folder);
  if (file_or_folder.extension() == ".toml") return print_case(to, file_or_folder);
  print_particles(to, file_or_folder);
}

}  // namespace thalweg
