#include <fmt/format.h>
#include <fmt/ostream.h>
#include <toml++/toml.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <ostream>
#include <sstream>

#include "case/reader/case_file.hpp"
#include "case/reader/tables.hpp"
#include "common/whole_file.hpp"

namespace thalweg {
namespace {

std::string toml_text(const std::string& text) {
  std::ostringstream stream;
  stream << toml::value<std::string>(text);
  return stream.str();
}

// The shortest digits that read back as the same number.
std::string quantity_text(double value, const char* unit) { return fmt::format("\"{} {}\"", value, unit); }

// Visits a table and prints its keys, of an entry of a list only those that `uses` it.
class TableWriter {
 public:
  using UsesKey = std::function<bool(const char*)>;
  TableWriter(std::ostream& to, int dimension, UsesKey uses = nullptr)
      : to_(to), dimension_(dimension), uses_(std::move(uses)) {}

  void quantity(const char* key, double& value, const char* unit, double, double, const char*) {
    if (!std::isnan(value)) line(key, quantity_text(value, unit));
  }
  void number(const char* key, double& value, double, double, const char*) {
    if (!std::isnan(value)) line(key, fmt::format("{}", value));
  }
  void integer(const char* key, int& value, int, int, const char*) { line(key, fmt::format("{}", value)); }
  void flag(const char* key, bool& value, const char*) { line(key, value ? "true" : "false"); }
  void text(const char* key, std::string& value, const char*) { line(key, toml_text(value)); }
  void texts(const char* key, std::vector<std::string>& values, const char*) {
    std::vector<std::string> entries;
    for (const std::string& value : values) entries.push_back(toml_text(value));
    list(key, entries);
  }
  void point(const char* key, Vec3& value, const char* unit, const char*) {
    if (value.hasNaN()) return;
    std::vector<std::string> entries{quantity_text(value.x(), unit), quantity_text(value.z(), unit)};
    if (dimension_ == 3) entries.insert(entries.begin() + 1, quantity_text(value.y(), unit));
    list(key, entries);
  }
  void direction(const char* key, Vec3& value, const char*) {
    if (dimension_ == 2) return line(key, fmt::format("[{}, {}]", value.x(), value.z()));
    line(key, fmt::format("[{}, {}, {}]", value.x(), value.y(), value.z()));
  }
  void quantities(const char* key, std::vector<double>& values, const char* unit, double, double, const char*) {
    std::vector<std::string> entries;
    for (const double value : values) entries.push_back(quantity_text(value, unit));
    list(key, entries);
  }
  void polygon(const char* key, std::vector<Eigen::Vector2d>& corners, const char* unit, const char*) {
    std::vector<std::string> entries;
    for (const Eigen::Vector2d& corner : corners)
      entries.push_back(fmt::format("[{}, {}]", quantity_text(corner.x(), unit), quantity_text(corner.y(), unit)));
    list(key, entries);
  }
  template <class E>
  void choice(const char* key, E& value, const char*) {
    for (const Choice<E>& word : choices(E{})) {
      if (word.value == value) line(key, toml_text(word.name));
    }
  }

 private:
  void line(const char* key, const std::string& value) {
    if (!uses_ || uses_(key)) fmt::print(to_, "{} = {}\n", key, value);
  }
  void list(const char* key, const std::vector<std::string>& entries) {
    line(key, fmt::format("[{}]", fmt::join(entries, ", ")));
  }

  std::ostream& to_;
  int dimension_;
  UsesKey uses_;
};

void write_values(std::ostream& to, Case values) {
  const int dimension = values.info.dimension;
  const auto write_table = [&](const std::string& name, auto& table) {
    fmt::print(to, "\n[{}]\n", name);
    TableWriter writer(to, dimension);
    table.describe(writer);
  };
  const auto write_shapes = [&] {
    for (Shape& shape : values.shapes) {
      fmt::print(to, "\n[[shape]]\n");
      TableWriter writer(to, dimension, [&](const char* key) { return shape_uses_key(shape, key, dimension); });
      shape.describe(writer);
    }
    for (Motion& motion : values.motions) {
      fmt::print(to, "\n[[motion]]\n");
      TableWriter writer(to, dimension, [&](const char* key) { return motion_uses_key(motion, key, dimension); });
      motion.describe(writer);
    }
  };
  const auto write_sediments = [&] {
    for (auto& [name, sediment] : values.sediments) write_table("materials." + toml_text(name), sediment);
  };
  const auto write_gauges = [&] {
    for (Gauge& gauge : values.gauges) {
      fmt::print(to, "\n[[gauge]]\n");
      TableWriter writer(to, dimension, [&](const char* key) { return gauge_uses_key(gauge, key); });
      gauge.describe(writer);
    }
    for (ProfileLine& line : values.lines) {
      fmt::print(to, "\n[[line]]\n");
      TableWriter writer(to, dimension);
      line.describe(writer);
    }
  };
  for_each_table(
      values, [&](const TableHeading& heading, auto& table) { write_table(heading.name, table); }, write_shapes,
      write_sediments, write_gauges);
}

}  // namespace

void write_case(const std::filesystem::path& file, const Case& resolved) {
  write_whole_text(file, [&](std::ostream& to) {
    fmt::print(to,
               "# The case as it was resolved: every key with its value. Written by thalweg " THALWEG_VERSION ".\n");
    fmt::print(to, "\n[resolved]\nfolder = {}\n", toml_text(resolved.folder.string()));
    if (!resolved.file_hashes.empty()) fmt::print(to, "\n[resolved.files]\n");
    for (const auto& [name, hash] : resolved.file_hashes) {
      fmt::print(to, "{} = {}\n", toml_text(name), toml_text(hash));
    }
    write_values(to, resolved);
  });
}

std::string hash_of_text(std::string_view text) {
  // FNV-1a, 64 bit (Fowler, Noll and Vo): told apart are cases, not attackers.
  std::uint64_t hash = 14695981039346656037U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
  return fmt::format("{:016x}", hash);
}

std::string hash_of(const Case& resolved) {
  std::ostringstream text;
  write_values(text, resolved);
  for (const auto& [name, hash] : resolved.file_hashes) fmt::print(text, "{} {}\n", name, hash);
  return hash_of_text(text.str());
}

}  // namespace thalweg
