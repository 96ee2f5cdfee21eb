#include "case/reader/case_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <set>
#include <sstream>

#include "case/check.hpp"
#include "case/reader/keys.hpp"
#include "case/reader/table_reader.hpp"
#include "case/reader/tables.hpp"
#include "case/reader/toml.hpp"
#include "common/csv.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

// Refuses keys that the table does not have; `path` is how the user writes the table in an override.
void check_keys(const toml::table& table, const TableDeclaration& declared, const std::string& path,
                const std::string& file) {
  std::vector<std::string> known;
  for (const KeyDeclaration& key : declared.keys) known.push_back(key.name);
  for (const auto& [name, node] : table) {
    const std::string key(name.str());
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    std::string cure = fmt::format("the keys of {} are {}", path, fmt::join(known, ", "));
    if (const auto near = nearest(key, known)) cure = fmt::format("did you mean {}.{}?", path, *near);
    for (const TableDeclaration& other : case_declarations()) {
      for (const KeyDeclaration& candidate : other.keys) {
        if (candidate.name == key) cure = fmt::format("did you mean {}?", candidate.full_name());
      }
    }
    const std::string where = where_is(node, file);
    const bool already_named = where.starts_with("--set ");
    reject_case(where, already_named ? "unknown key" : fmt::format("unknown key {}.{}", path, key), cure);
  }
}

const toml::table& as_table(const toml::node& node, const std::string& name, const std::string& file) {
  if (!node.is_table())
    reject_case(where_is(node, file), fmt::format("{} is no table", name), fmt::format("write [{}]", name));
  return *node.as_table();
}

// `list` is "shape", "gauge" …
void check_list(const toml::node& node, const std::string& list, const std::string& file) {
  if (!node.is_array() || !node.as_array()->is_homogeneous(toml::node_type::table)) {
    reject_case(where_is(node, file), fmt::format("{} is no list of tables", list),
                fmt::format("write [[{0}]] above each {0}", list));
  }
  std::set<std::string> names;
  for (const toml::node& entry : *node.as_array()) {
    const toml::table& table = *entry.as_table();
    const std::string name = name_of_entry(table);
    const toml::node* name_node = table.get("name");
    if (name_node == nullptr) {
      reject_case(where_is(entry, file), fmt::format("a {} has no name", list), "add name = \"...\"");
    }
    if (name.empty()) {
      reject_case(where_is(*name_node, file), fmt::format("a {}'s name must be a text", list), "write name = \"...\"");
    }
    if (!names.insert(name).second) {
      reject_case(where_is(*name_node, file), fmt::format("the name \"{}\" is used twice", name),
                  fmt::format("rename one of the {}s", list));
    }
    check_keys(table, *find_table(list), fmt::format("{}.{}", list, name), file);
  }
}

[[noreturn]] void reject_unknown_table(const std::string& name, const toml::node& node,
                                       const std::vector<std::string>& known, const std::string& file) {
  const bool is_table = node.is_table() || node.is_array();
  std::string cure = fmt::format("the tables are {}", fmt::join(known, ", "));
  if (const auto near = nearest(name, known)) cure = fmt::format("did you mean {}?", *near);
  for (const TableDeclaration& table : case_declarations()) {
    for (const KeyDeclaration& key : table.keys) {
      if (!is_table && key.name == name) cure = fmt::format("did you mean {}?", key.full_name());
    }
  }
  reject_case(where_is(node, file), fmt::format("unknown {} {}", is_table ? "table" : "key", name), cure);
}

void check_names(const toml::table& root, const std::string& file) {
  std::vector<std::string> known{"shape", "motion", "gauge", "line", "materials"};
  for (const TableDeclaration& table : case_declarations()) {
    if (table.name.find_first_of("[.") == std::string::npos) known.push_back(table.name);
  }
  for (const auto& [name, node] : root) {
    const std::string table(name.str());
    if (is_list_of_tables(table)) {
      check_list(node, table, file);
    } else if (table == "materials") {
      for (const auto& [material, values] : as_table(node, table, file)) {
        const std::string path = "materials." + std::string(material.str());
        check_keys(as_table(values, path, file), *find_table(path), path, file);
      }
    } else if (table == "resolved") {
      continue;  // of case.resolved.toml
    } else if (std::find(known.begin(), known.end(), table) != known.end()) {
      check_keys(as_table(node, table, file), *find_table(table), table, file);
    } else {
      reject_unknown_table(table, node, known, file);
    }
  }
}

class CaseReader {
 public:
  CaseReader(const toml::table& root, const fs::path& file) : root_(root) {
    origins_.file = file.string();
    result_.file = file;
    result_.folder = fs::absolute(file).lexically_normal().parent_path();
    result_.info.name = result_.folder.filename().string();
    const auto original = root_["resolved"]["folder"].value<std::string>();
    if (original) {
      result_.folder = *original;
      origins_.given["resolved"] = origins_.file;
    }
  }

  Case read() {
    if (root_["model"]["implementation"].value<std::string>() == "paper") take_printed_defaults();
    if (const toml::node* accuracy = root_["numerics"]["accuracy"].node()) take_accuracy(*accuracy);
    for_each_table(
        result_, [&](const TableHeading& heading, auto& table) { read_table(heading.name, table); },
        [&] { read_list("shape", result_.shapes), read_list("motion", result_.motions); }, [&] { read_sediments(); },
        [&] { read_list("gauge", result_.gauges), read_list("line", result_.lines); });
    name_materials();
    check_case(result_, origins_);
    for (Motion& motion : result_.motions) take_table(motion);
    hash_files();
    return std::move(result_);
  }

 private:
  /// What model.implementation = "paper" means where the case says nothing itself.
  void take_printed_defaults() {
    result_.model.yield_fit = YieldFit::paper;
    result_.model.bed_shear = BedShear::paper;
    sediment_defaults_.consistency = 1.54;  // [Pa s^n] 0.001 m^2/s times the paper's 1540 kg/m^3
    sediment_defaults_.flow_index = 1.8;
  }

  /// What numerics.accuracy means where the case says nothing itself. A resolved case says everything.
  void take_accuracy(const toml::node& node) {
    const std::string where = where_is(node, origins_.file);
    if (root_["resolved"] && where.starts_with("--set ")) {
      reject_case(where, "numerics.accuracy sets defaults, and a resolved case has none left",
                  "fill the scene again: thalweg gencase CASE --set numerics.accuracy=...");
    }
    for (const auto& choice : choices(Accuracy{})) {
      if (node.value<std::string>() == choice.name) result_.numerics = numerics_at(choice.value);
    }
  }

  template <class Table>
  void read_table(const std::string& path, Table& table) {
    TableReader reader(root_.at_path(path).as_table(), path, result_.info.dimension, origins_);
    table.describe(reader);
  }

  template <class Entry>
  void read_list(const std::string& list, std::vector<Entry>& entries) {
    const toml::array* nodes = root_[list].as_array();
    if (nodes == nullptr) return;
    for (const toml::node& node : *nodes) {
      Entry& entry = entries.emplace_back();
      const std::string path = fmt::format("{}.{}", list, name_of_entry(*node.as_table()));
      TableReader reader(node.as_table(), path, result_.info.dimension, origins_);
      entry.describe(reader);
      if constexpr (std::is_same_v<Entry, Shape>) entry.line = static_cast<int>(node.source().begin.line);
    }
  }

  /// The rows of a motion's file become its own, so that the resolved case holds them.
  void take_table(Motion& motion) const {
    if (motion.file.empty()) return;
    const CsvTable table = CsvTable::read(result_.folder / motion.file);
    motion.times = table.numbers("time", "s");
    if (motion.kind == MotionKind::rotation) {
      const auto& columns = table.columns();
      const bool degrees = std::any_of(columns.begin(), columns.end(), [](const CsvColumn& column) {
        return column.name == "angle" && column.unit == "deg";
      });
      motion.angles = table.numbers("angle", degrees ? "deg" : "rad");
      if (degrees) {
        for (double& angle : motion.angles) angle *= std::numbers::pi / 180;
      }
    } else {
      motion.displacements = table.numbers("displacement", "m");
    }
    const std::vector<double>& values = motion.kind == MotionKind::rotation ? motion.angles : motion.displacements;
    if (values.size() < 2) throw InputError(table.where() + ": the table has less than two rows; add some");
    for (std::size_t row = 0; row < values.size(); ++row) {
      if (!std::isfinite(values[row]) || !(motion.times[row] >= 0) || !std::isfinite(motion.times[row])) {
        throw InputError(table.where(row) + ": the row lacks a number or its time is negative; give both");
      }
      if (row > 0 && !(motion.times[row] > motion.times[row - 1])) {
        throw InputError(table.where(row) + ": the time is not after that of the row before; sort the rows");
      }
    }
    motion.file.clear();
  }

  /// A run's folder may be looked at where the files are not: it carries their hashes along.
  void hash_files() {
    if (const toml::table* known = root_["resolved"]["files"].as_table()) {
      for (const auto& [name, hash] : *known) result_.file_hashes[std::string(name.str())] = hash.value_or("");
      return;
    }
    for (const Shape& shape : result_.shapes) {
      if (shape.file.empty()) continue;
      const std::ifstream file(result_.folder / shape.file, std::ios::binary);
      if (!file) continue;  // gencase says so when it needs it
      std::ostringstream content;
      content << file.rdbuf();
      result_.file_hashes[shape.file] = hash_of_text(content.str());
    }
  }

  void read_sediments() {
    const toml::table* materials = root_["materials"].as_table();
    if (materials == nullptr) return;
    for (const auto& [name, node] : *materials) {
      if (name.str() == "water") continue;
      const std::string path = fmt::format("materials.{}", name.str());
      TableReader reader(node.as_table(), path, result_.info.dimension, origins_);
      result_.sediments.try_emplace(std::string(name.str()), sediment_defaults_).first->second.describe(reader);
    }
  }

  void name_materials() {
    if (result_.sediments.size() != 1) return;
    for (Shape& shape : result_.shapes) {
      if (shape.role == ShapeRole::sediment && shape.material.empty())
        shape.material = result_.sediments.begin()->first;
    }
  }

  const toml::table& root_;
  CaseOrigins origins_;
  Case result_;
  SedimentParameters sediment_defaults_;
};

fs::path find_case_file(const fs::path& given) {
  if (fs::is_regular_file(given)) return given;
  const fs::path inside = given / "case.toml";
  if (fs::is_regular_file(inside)) return inside;
  reject_case(given.string(),
              fs::is_directory(given) ? "the folder holds no case.toml" : "there is no such file or folder",
              "name a folder with case.toml, or the file");
}

}  // namespace

Case read_case(const fs::path& case_path, const std::vector<std::string>& overrides) {
  const fs::path file = find_case_file(case_path);
  toml::table root = parse_case_toml(file);
  for (const std::string& text : overrides) apply_override(root, text);
  check_names(root, file.string());
  return CaseReader(root, file).read();
}

}  // namespace thalweg
