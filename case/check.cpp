#include "case/check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include "case/reader/keys.hpp"
#include "case/reader/tables.hpp"
#include "common/error.hpp"
#include "common/units.hpp"

namespace thalweg {
namespace {

constexpr std::array axis_names{"x", "y", "z"};

class CaseCheck {
 public:
  CaseCheck(const Case& read, const CaseOrigins& origins) : case_(read), origins_(origins) {}

  void all() const {
    case_name();
    domain();
    for (std::size_t i = 0; i < case_.shapes.size(); ++i) shape(i);
    for (const Motion& each : case_.motions) motion(each);
    phases();
    seepage();
    numerics();
    times();
    for (const Gauge& each : case_.gauges) gauge(each);
    for (const ProfileLine& each : case_.lines) line(each);
    references();
    mesh_models();
  }

 private:
  [[noreturn]] void reject(const std::string& key, const std::string& what, const std::string& cure) const {
    throw InputError(fmt::format("{}: {}; {}", origins_.where(key), what, cure));
  }

  [[nodiscard]] bool uses(int axis) const { return case_.info.dimension == 3 || axis != 1; }

  void case_name() const { names_files("case.name", case_.info.name); }

  void names_files(const std::string& key, const std::string& name) const {
    const bool usable = !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
      return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.';
    });
    if (!usable || name.front() == '.') {
      reject(key, fmt::format("{} = \"{}\" cannot name files", key, name), "use letters, digits, \"-\" and \"_\"");
    }
  }

  void mesh_models() const {
    for (const std::string& model : case_.foam.models) {
      if (std::ranges::find(mesh_model_names, model) != mesh_model_names.end()) continue;
      reject("foam.models", fmt::format("foam.models holds \"{}\"", model),
             fmt::format("the mesh models are {}", fmt::join(mesh_model_names, ", ")));
    }
  }

  // `table` has a box between `from` and `to`.
  void corners(const std::string& table, const Vec3& from, const Vec3& to) const {
    for (int axis = 0; axis < 3; ++axis) {
      if (uses(axis) && from[axis] >= to[axis]) {
        reject(table + ".to", fmt::format("{0}.to is not beyond {0}.from in {1}", table, axis_names.at(axis)),
               "give the lower corner first and some extent in every direction");
      }
    }
  }

  void domain() const {
    corners("domain", case_.domain.from, case_.domain.to);
    std::set<std::string> seen;
    for (const std::string& direction : case_.domain.periodic) {
      const bool known = direction == "x" || direction == "z" || (direction == "y" && uses(1));
      if (!known) {
        reject("domain.periodic", fmt::format("domain.periodic names \"{}\"", direction),
               uses(1) ? "the directions are x, y, z" : "the directions are x, z with dimension = 2");
      }
      if (!seen.insert(direction).second) {
        reject("domain.periodic", fmt::format("domain.periodic names \"{}\" twice", direction), "remove one");
      }
    }
  }

  void shape(std::size_t index) const {
    const Shape& s = case_.shapes[index];
    const std::string path = "shape." + s.name;
    shape_keys(s, path);
    if (s.kind == ShapeKind::box) corners(path, s.from, s.to);
    if (shape_uses_key(s, "radius", case_.info.dimension) && !(s.radius > 0)) {
      reject(path + ".radius", fmt::format("{}.radius is zero", path), "give a positive radius");
    }
    if (s.kind == ShapeKind::cylinder && case_.info.dimension == 3 && s.from == s.to) {
      reject(path + ".to", fmt::format("{0}.to equals {0}.from", path), "give the axis some length");
    }
    if (s.kind == ShapeKind::cone && s.from == s.to) {
      reject(path + ".to", fmt::format("{0}.to equals {0}.from", path), "give the axis some length");
    }
    if (s.kind == ShapeKind::prism) prism(s, path);
    if (s.kind == ShapeKind::layer && !(s.thickness > 0)) {
      reject(path + ".thickness", fmt::format("{}.thickness is zero", path), "give the layer some height");
    }
    three_entries(path + ".rotate", s.rotate);
    three_entries(path + ".move", s.move);
    members(index, path);
    role(s, path);
    open_faces(s, path);
    inside_domain(s, path);
  }

  void prism(const Shape& s, const std::string& path) const {
    if (s.polygon.size() < 3) {
      reject(path + ".polygon", fmt::format("{}.polygon has {} corners", path, s.polygon.size()),
             "give at least three");
    }
    if (case_.info.dimension == 3 && (s.extent.size() != 2 || s.extent[0] >= s.extent[1])) {
      reject(path + ".extent", fmt::format("{}.extent is no range", path),
             "give two places along the axis, the lower one first");
    }
  }

  void three_entries(const std::string& key, const std::vector<double>& values) const {
    if (!values.empty() && values.size() != 3) {
      reject(key, fmt::format("{} has {} entries", key, values.size()), "give three, for x, y and z");
    }
  }

  void shape_keys(const Shape& s, const std::string& path) const {
    for (const std::string& key : shape_needs_keys(s, case_.info.dimension)) {
      if (!origins_.has(path + "." + key)) {
        reject(path, fmt::format("{}.{} is missing", path, key),
               fmt::format("a shape of kind \"{}\" needs {}", kind_name(s.kind), needed_keys(s)));
      }
    }
    for (const KeyDeclaration& key : find_table("shape")->keys) {
      const std::string full = path + "." + key.name;
      if (origins_.has(full) && !shape_uses_key(s, key.name, case_.info.dimension)) {
        reject(full, fmt::format("{} means nothing for a shape of kind \"{}\" and this role", full, kind_name(s.kind)),
               "remove it");
      }
    }
  }

  static std::string kind_name(ShapeKind kind) {
    for (const Choice<ShapeKind>& choice : choices(ShapeKind{})) {
      if (choice.value == kind) return choice.name;
    }
    return {};
  }
  [[nodiscard]] std::string needed_keys(const Shape& s) const {
    return fmt::format("{}", fmt::join(shape_needs_keys(s, case_.info.dimension), ", "));
  }

  void members(std::size_t index, const std::string& path) const {
    const Shape& s = case_.shapes[index];
    if (!shape_uses_key(s, "of", case_.info.dimension)) return;
    if (s.of.size() < 2) {
      reject(path + ".of", fmt::format("{}.of names {} shapes", path, s.of.size()), "name at least two");
    }
    std::vector<std::string> earlier;
    for (std::size_t i = 0; i < index; ++i) earlier.push_back(case_.shapes[i].name);
    for (const std::string& name : s.of) {
      if (std::find(earlier.begin(), earlier.end(), name) != earlier.end()) continue;
      const bool later =
          std::any_of(case_.shapes.begin(), case_.shapes.end(), [&](const Shape& other) { return other.name == name; });
      if (later)
        reject(path + ".of", fmt::format("{}.of names \"{}\", which does not come before it", path, name),
               "move that shape up");
      const auto near = nearest(name, earlier);
      reject(path + ".of", fmt::format("{}.of names \"{}\", which is no shape", path, name),
             near ? fmt::format("did you mean \"{}\"?", *near)
                  : fmt::format("the shapes before it are {}", fmt::join(earlier, ", ")));
    }
  }

  void role(const Shape& s, const std::string& path) const {
    const bool is_wall = s.role == ShapeRole::wall || s.role == ShapeRole::moving_wall;
    const bool of_container = s.kind == ShapeKind::level || s.kind == ShapeKind::layer;
    if (of_container && is_wall) {
      reject(path + ".role", fmt::format("{} fills a container and cannot be a wall", path),
             "give it the role \"water\" or \"sediment\"");
    }
    if (s.side == WallSide::both && s.kind != ShapeKind::mesh) {
      reject(path + ".side", fmt::format("{}.side = \"both\" is for meshes", path),
             "use \"inside\" for a solid, \"outside\" for a container");
    }
    if (s.role == ShapeRole::none) {
      const bool used = std::any_of(case_.shapes.begin(), case_.shapes.end(), [&](const Shape& other) {
        return std::find(other.of.begin(), other.of.end(), s.name) != other.of.end();
      });
      if (!used) reject(path, fmt::format("{} has no role and no other shape uses it", path), "give it a role");
    }
    if (s.role == ShapeRole::moving_wall) motion_of(s, path);
    if (s.role != ShapeRole::sediment) return;
    std::vector<std::string> known;
    for (const auto& [name, parameters] : case_.sediments) known.push_back(name);
    if (known.empty())
      reject(path, fmt::format("{} is sediment, and no sediment is defined", path),
             "add a table [materials.<name>] for it");
    if (s.material.empty()) {
      reject(path, fmt::format("{}.material is missing", path),
             fmt::format("there are several sediments; name one of {}", fmt::join(known, ", ")));
    }
    if (!case_.sediments.contains(s.material)) {
      reject(path + ".material", fmt::format("{}.material = \"{}\" is no sediment", path, s.material),
             fmt::format("the sediments are {}", fmt::join(known, ", ")));
    }
  }

  void motion_of(const Shape& s, const std::string& path) const {
    if (s.motion.empty()) {
      reject(path + ".role", fmt::format("{} is a moving wall without a motion", path),
             "add motion = \"...\" and a table [[motion]] of that name");
    }
    std::vector<std::string> known;
    for (const Motion& each : case_.motions) known.push_back(each.name);
    if (std::find(known.begin(), known.end(), s.motion) != known.end()) return;
    const auto near = nearest(s.motion, known);
    reject(path + ".motion", fmt::format("{}.motion = \"{}\" is no motion", path, s.motion),
           known.empty() ? "add a table [[motion]] of that name"
           : near        ? fmt::format("did you mean \"{}\"?", *near)
                         : fmt::format("the motions are {}", fmt::join(known, ", ")));
  }

  void motion(const Motion& m) const {
    const std::string path = "motion." + m.name;
    motion_keys(m, path);
    const bool used = std::any_of(case_.shapes.begin(), case_.shapes.end(), [&](const Shape& s) {
      return s.role == ShapeRole::moving_wall && s.motion == m.name;
    });
    if (!used) {
      reject(path, fmt::format("{} moves no shape", path),
             "name it as `motion` of a shape with role = \"moving wall\", or remove it");
    }
    if (m.kind == MotionKind::piecewise_linear) motion_table(m, path, "displacements", m.displacements);
    if (m.kind == MotionKind::rotation) rotation(m, path);
    if (m.kind == MotionKind::gate_lift && !(m.speed > 0 || m.acceleration > 0)) {
      reject(path, fmt::format("{} has neither speed nor acceleration", path), "give one of them");
    }
    if (m.kind == MotionKind::oscillation && !(m.period > 0)) {
      reject(path + ".period", fmt::format("{}.period is zero", path), "give the time of one to and fro");
    }
    if (case_.model.seepage == SeepageModel::mixture) {
      reject("model.seepage", "a mixture of grains and water has no moving walls", "remove one of the two");
    }
    if (case_.numerics.integrator == Integrator::two_pass) {
      reject("numerics.integrator", "the two-pass integrator has no moving walls", "write integrator = \"leapfrog\"");
    }
  }

  void motion_keys(const Motion& m, const std::string& path) const {
    const std::vector<std::string> needed = motion_needs_keys(m, case_.info.dimension);
    std::string kind;
    for (const Choice<MotionKind>& word : choices(MotionKind{})) {
      if (word.value == m.kind) kind = word.name;
    }
    for (const std::string& key : needed) {
      if (!origins_.has(path + "." + key)) {
        reject(path, fmt::format("{}.{} is missing", path, key),
               fmt::format("a motion of kind \"{}\" needs {}", kind, fmt::join(needed, ", ")));
      }
    }
    for (const KeyDeclaration& key : find_table("motion")->keys) {
      const std::string full = path + "." + key.name;
      if (origins_.has(full) && !motion_uses_key(m, key.name, case_.info.dimension)) {
        reject(full, fmt::format("{} means nothing for a motion of kind \"{}\"", full, kind), "remove it");
      }
    }
  }

  void rotation(const Motion& m, const std::string& path) const {
    const bool by_table = !m.file.empty() || !m.times.empty() || !m.angles.empty();
    if (m.angular_speed == 0) return motion_table(m, path, "angles", m.angles);
    if (by_table) {
      reject(path, fmt::format("{} has an angular_speed and a table", path), "choose one of the two");
    }
  }

  void motion_table(const Motion& m, const std::string& path, const std::string& column,
                    const std::vector<double>& values) const {
    const std::string by_speed = column == "angles" ? ", or angular_speed" : "";
    if (!m.file.empty() && (!m.times.empty() || !values.empty())) {
      reject(path + ".file", fmt::format("{} has a file and a table of its own", path), "choose one of the two");
    }
    if (!m.file.empty()) return;
    if (m.times.empty() && values.empty()) {
      reject(path, fmt::format("{} does not say how far it goes", path),
             fmt::format("give times and {}, or a file{}", column, by_speed));
    }
    if (m.times.size() != values.size() || values.size() < 2) {
      reject(path + "." + column, fmt::format("{} has {} times and {} {}", path, m.times.size(), values.size(), column),
             "give as many of both, two at least");
    }
    for (std::size_t i = 1; i < m.times.size(); ++i) {
      if (!(m.times[i] > m.times[i - 1])) {
        reject(path + ".times", fmt::format("{}.times has {} s after {} s", path, m.times[i], m.times[i - 1]),
               "let them increase");
      }
    }
    if (column == "angles" && m.start > 0) {
      reject(path + ".start", fmt::format("{}.start means nothing with a table", path), "begin the table later");
    }
  }

  void open_faces(const Shape& s, const std::string& path) const {
    for (const std::string& face : s.open) {
      const bool known = face.size() == 2 && (face[0] == '-' || face[0] == '+') &&
                         (face[1] == 'x' || face[1] == 'z' || (face[1] == 'y' && uses(1)));
      if (!known) {
        reject(path + ".open", fmt::format("{}.open names \"{}\"", path, face),
               uses(1) ? "the faces are -x, +x, -y, +y, -z, +z" : "the faces are -x, +x, -z, +z with dimension = 2");
      }
    }
  }

  // Lower and upper corner of a single solid; nothing for combinations, whose extent only the geometry kernel knows.
  [[nodiscard]] std::optional<std::pair<Vec3, Vec3>> bounds(const Shape& s) const {
    const bool disc = s.kind == ShapeKind::sphere || (s.kind == ShapeKind::cylinder && case_.info.dimension == 2);
    if (s.kind == ShapeKind::box) return std::pair{s.from, s.to};
    if (disc) return std::pair<Vec3, Vec3>{s.center - Vec3::Constant(s.radius), s.center + Vec3::Constant(s.radius)};
    if (s.kind != ShapeKind::cylinder) return std::nullopt;
    const Vec3 axis = (s.to - s.from).normalized();
    const Vec3 reach =
        s.radius * (Vec3::Ones() - axis.cwiseAbs2()).cwiseMax(0).cwiseSqrt();  // of the discs at its ends
    return std::pair<Vec3, Vec3>{s.from.cwiseMin(s.to) - reach, s.from.cwiseMax(s.to) + reach};
  }

  void inside_domain(const Shape& s, const std::string& path) const {
    const auto extent = bounds(s);
    if (!extent || (s.role != ShapeRole::water && s.role != ShapeRole::sediment)) return;
    for (int axis = 0; axis < 3; ++axis) {
      if (!uses(axis)) continue;
      if (extent->first[axis] < case_.domain.from[axis] || extent->second[axis] > case_.domain.to[axis]) {
        reject(path, fmt::format("{} reaches beyond the domain in {}", path, axis_names.at(axis)),
               "enlarge [domain] or reduce the shape");
      }
    }
  }

  void phases() const {
    const bool has_water = std::any_of(case_.shapes.begin(), case_.shapes.end(),
                                       [](const Shape& s) { return s.role == ShapeRole::water; });
    if (!has_water && !case_.has_sediment()) {
      reject("shape", "no shape has the role water or sediment", "add one, or there is nothing to move");
    }
    if (case_.has_sediment() && case_.model.sediment == SedimentModel::off) {
      reject("model.sediment", "there is a sediment shape, and model.sediment is off",
             "write sediment = \"viscoplastic\" in [model]");
    }
    if (case_.model.yield == YieldCriterion::mohr_coulomb && origins_.has("model.yield_fit") &&
        !origins_.has("resolved")) {
      reject("model.yield_fit", "model.yield_fit means nothing with yield = \"mohr-coulomb\"", "remove it");
    }
    for (const auto& [name, sediment] : case_.sediments) {
      if (case_.model.rheology == Rheology::mu_of_i && sediment.dynamic_friction_angle <= sediment.friction_angle) {
        const std::string key = fmt::format("materials.{}.dynamic_friction_angle", name);
        reject(key, fmt::format("{} is not above friction_angle, and rheology is \"mu-of-i\"", key),
               "give the friction angle of a fast flow, some 12 deg above");
      }
    }
    if (case_.model.sediment == SedimentModel::three_state && !(case_.domain.gravity.norm() > 0)) {
      reject("model.sediment", "sediment = \"three-state\" needs gravity: grains roll and settle by their weight",
             "give domain.gravity, or write sediment = \"viscoplastic\"");
    }
    if (case_.model.sediment == SedimentModel::three_state && !(case_.water.viscosity > 0)) {
      reject("materials.water.viscosity",
             "sediment = \"three-state\" needs the water's viscosity for shear and settling",
             "give it, or write sediment = \"viscoplastic\"");
    }
    if (!case_.has_sediment() && case_.model.sediment != SedimentModel::off) {
      reject("model.sediment", "model.sediment is on, and no shape has the role sediment",
             "add a sediment shape or write sediment = \"off\"");
    }
  }

  void seepage() const {
    const bool mixture = case_.model.seepage == SeepageModel::mixture;
    const bool diffusion = case_.model.pore_pressure == PorePressureModel::diffusion;
    const std::string key = mixture ? "model.seepage" : "model.pore_pressure";
    if (!mixture && !diffusion) return;
    if (!case_.has_sediment()) reject(key, key + " is on, and no shape has the role sediment", "remove it");
    if (mixture && diffusion) {
      reject("model.pore_pressure", "a mixture has the pressure of its pore water already", "choose one of the two");
    }
    if (case_.model.effective_pressure != EffectivePressure::column) {
      reject("model.effective_pressure", key + " takes the effective pressure from the columns", "write \"column\"");
    }
    if (mixture && case_.numerics.integrator == Integrator::two_pass) {
      reject("numerics.integrator", "the two-pass integrator knows no mixture", "write integrator = \"leapfrog\"");
    }
    if (mixture && case_.model.sediment != SedimentModel::viscoplastic) {
      reject("model.sediment", "the grains of a mixture have no states", "write sediment = \"viscoplastic\"");
    }
    if (mixture && case_.numerics.viscosity != ViscosityTreatment::implicit) {
      reject("numerics.viscosity", "drag in a mixture is part of the implicit solve", "write \"implicit\"");
    }
    const SedimentParameters& s = case_.sediment();
    if (s.pore_density != case_.water.density) {
      reject(key, key + " needs pores full of the scene's water", "give pore_density the density of water");
    }
    if (!(s.porosity >= 0.2)) reject(key, key + " needs a porosity of 0.2 or more", "use Ergun's law where it holds");
    if (!(case_.water.viscosity > 0))
      reject(key, key + " needs the water's viscosity", "give materials.water.viscosity");
  }

  void numerics() const {
    for (int axis = 0; axis < 3; ++axis) {
      const double extent = case_.domain.to[axis] - case_.domain.from[axis];
      if (uses(axis) && case_.numerics.spacing > extent) {
        reject("numerics.spacing",
               fmt::format("numerics.spacing = {} is larger than the domain in {} ({})",
                           format_quantity(case_.numerics.spacing, "m"), axis_names.at(axis),
                           format_quantity(extent, "m")),
               "reduce it");
      }
    }
    if (case_.numerics.maximum_speed == 0 && case_.domain.gravity.isZero(0)) {
      reject("numerics.maximum_speed", "without gravity the largest speed cannot be estimated",
             "give numerics.maximum_speed");
    }
  }

  void times() const {
    const auto within_run = [&](const std::string& key, const std::vector<double>& times) {
      for (const double time : times) {
        if (time > case_.output.end) {
          reject(key, fmt::format("{} has {} s, after output.end = {} s", key, time, case_.output.end),
                 "give times within the run or extend it");
        }
      }
    };
    within_run("output.times", case_.output.times);
    within_run("compare.times", case_.compare.times);
    if (case_.compare.from > case_.compare.to) {
      reject("compare.to", "compare.to lies before compare.from", "exchange them");
    }
  }

  void gauge(const Gauge& g) const {
    const std::string path = "gauge." + g.name;
    names_files(path + ".name", g.name);
    for (const char* key : {"at", "from", "to"}) {
      const std::string full = fmt::format("{}.{}", path, key);
      const bool used = gauge_uses_key(g, key);
      if (used == origins_.has(full)) continue;
      if (used) reject(path, full + " is missing", "give the place of the gauge");
      reject(full, full + " means nothing for a gauge of this kind", "remove it");
    }
    if (g.kind != GaugeKind::flux) return inside_domain(path + ".at", g.at);
    int equal = 0;
    for (int axis = 0; axis < 3; ++axis) equal += uses(axis) && g.from[axis] == g.to[axis] ? 1 : 0;
    if (equal != 1) {
      reject(path + ".to", fmt::format("{0}.from and {0}.to are equal along {1} axes", path, equal),
             "give two corners of a rectangle across one axis");
    }
  }

  void inside_domain(const std::string& key, const Vec3& at) const {
    for (int axis = 0; axis < 3; ++axis) {
      if (uses(axis) && !(at[axis] >= case_.domain.from[axis] && at[axis] <= case_.domain.to[axis])) {
        reject(key, fmt::format("{} lies outside the domain in {}", key, axis_names.at(axis)), "move it inside");
      }
    }
  }

  void line(const ProfileLine& l) const {
    const std::string path = "line." + l.name;
    names_files(path + ".name", l.name);
    if (l.name == "all") reject(path + ".name", path + ".name is taken by the profiles of all snapshots", "rename it");
    if (case_.info.dimension == 2) {
      reject(path, "a case with dimension = 2 has one profile, along x", "remove [[line]]");
    }
    for (const auto& [key, place] : {std::pair{".from", &l.from}, std::pair{".to", &l.to}}) {
      if (place->size() != 2) {
        reject(path + key, fmt::format("{}{} has {} entries", path, key, place->size()), "give two, x and y");
      }
    }
    if (l.from == l.to) reject(path + ".to", fmt::format("{0}.to equals {0}.from", path), "give the line some length");
  }

  // A run's folder may be computed on another machine than the one that holds the references.
  void references() const {
    if (origins_.has("resolved")) return;
    for (const std::string& folder : case_.compare.references) {
      if (!std::filesystem::is_directory(case_.folder / folder)) {
        reject("compare.references", fmt::format("compare.references names \"{}\", which is no folder", folder),
               "give it relative to the folder of the case file");
      }
    }
  }

  const Case& case_;
  const CaseOrigins& origins_;
};

}  // namespace

std::string CaseOrigins::where(std::string name) const {
  for (;;) {
    if (const auto found = given.find(name); found != given.end()) return found->second;
    const auto dot = name.rfind('.');
    if (dot == std::string::npos) return file + ":1";
    name.resize(dot);
  }
}

void check_case(const Case& read, const CaseOrigins& origins) { CaseCheck(read, origins).all(); }

}  // namespace thalweg
