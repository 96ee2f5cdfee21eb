#pragma once

#include <array>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "common/particles.hpp"
#include "physics/sediment/drucker_prager.hpp"
#include "physics/sediment/effective_pressure.hpp"
#include "physics/sediment/mohr_coulomb.hpp"
#include "physics/sediment/mu_of_i.hpp"
#include "physics/sediment/sediment_parameters.hpp"
#include "physics/transport/bed_load.hpp"
#include "physics/transport/bed_shear.hpp"
#include "physics/transport/pick_up.hpp"
#include "physics/water/viscosity_treatment.hpp"

/// What a case file can say. Every table is a struct whose describe() declares each key once: name, member, unit,
/// admissible range, one sentence; the member's initial value is the default (`required` where there is none). Parser,
/// `thalweg explain`, docs/case-file.md and the JSON schema are four visitors of the same declarations.
///
/// A visitor offers:
///   quantity(key, double&, si_unit, low, high, sentence)        a text with a unit
///   number(key, double&, low, high, sentence)                   a plain number (dimensionless)
///   integer(key, int&, low, high, sentence)
///   flag(key, bool&, sentence)
///   text(key, std::string&, sentence)
///   texts(key, std::vector<std::string>&, sentence)
///   point(key, Vec3&, si_unit, sentence)                        one entry per dimension: [x, z] in 2-D, [x, y, z] in
///   3-D quantities(key, std::vector<double>&, si_unit, low, high, sentence) polygon(key, std::vector<Vector2d>&,
///   si_unit, sentence) [[x, z], …] choice(key, E&, sentence) the names come from choices(E)
///   direction(key, Vec3&, sentence)                             plain numbers, one per dimension; any length but zero
namespace thalweg {

/// Marks a number the case file has to give.
inline constexpr double required = std::numeric_limits<double>::quiet_NaN();

/// One admissible word of an enumerated key.
template <class E>
struct Choice {
  E value;
  const char* name;
  const char* sentence;
};

struct CaseInfo {
  std::string name;
  std::string title;
  std::string source;
  int dimension = 2;

  template <class V>
  void describe(V& v) {
    v.text("name", name, "Short name, used for folders and file names; default: the name of the case's folder.");
    v.text("title", title, "One line for reports.");
    v.text("source", source, "Where geometry, constants and data come from.");
    v.integer("dimension", dimension, 2, 3, "2: the plane x-z per metre of width; 3: space.");
  }
};

struct Domain {
  Vec3 from = Vec3::Constant(required);  // [m]
  Vec3 to = Vec3::Constant(required);    // [m]
  Vec3 gravity{0, 0, -9.81};             // [m/s^2]
  std::vector<std::string> periodic;

  template <class V>
  void describe(V& v) {
    v.point("from", from, "m", "Lower corner of the domain; particles that leave the domain are excluded and counted.");
    v.point("to", to, "m", "Upper corner of the domain.");
    v.point("gravity", gravity, "m/s^2", "Acceleration of gravity.");
    v.texts("periodic", periodic, "Directions in which the domain repeats itself: any of \"x\", \"y\", \"z\".");
  }
};

enum class ShapeKind {
  box,
  cylinder,
  cone,
  sphere,
  prism,
  mesh,
  bathymetry,
  level,
  layer,
  combine_union,
  combine_difference,
  combine_intersection
};
enum class ShapeRole { none, water, sediment, wall, moving_wall, empty };
enum class WallSide { inside, outside, both };
enum class Axis { x, y, z };
enum class BooleanMethod { exact, voxel };

inline constexpr std::array<Choice<ShapeKind>, 12> choices(ShapeKind) {
  return {{{ShapeKind::box, "box", "between the corners `from` and `to`"},
           {ShapeKind::cylinder, "cylinder",
            "`radius` around the segment from `from` to `to` (3-D), or a disc around `center` (2-D)"},
           {ShapeKind::cone, "cone",
            "`radius` at `from`, `end_radius` at `to`: a cone or a frustum; in 2-D its cut through the axis"},
           {ShapeKind::sphere, "sphere", "`radius` around `center`; a disc in 2-D"},
           {ShapeKind::prism, "prism", "the `polygon`, in 3-D along `axis` over `extent`"},
           {ShapeKind::mesh, "mesh",
            "the closed surface in `file` (STL, OBJ, OFF, PLY or VTP), scaled, rotated, then moved; in 2-D its cut by "
            "the plane y = 0"},
           {ShapeKind::bathymetry, "bathymetry",
            "everything between the height `base` and the surface in `file`: points x, y, z in a CSV table, x, z for a "
            "surface without change in y, or an open surface mesh"},
           {ShapeKind::level, "level", "the inside of the containers before it in the case, up to `level`"},
           {ShapeKind::layer, "layer", "`thickness` above the floor that the walls before it leave in the containers"},
           {ShapeKind::combine_union, "union", "all of the shapes named in `of`"},
           {ShapeKind::combine_difference, "difference", "the first shape of `of` without the others"},
           {ShapeKind::combine_intersection, "intersection", "what the shapes of `of` share"}}};
}
inline constexpr std::array<Choice<ShapeRole>, 6> choices(ShapeRole) {
  return {{{ShapeRole::none, "none", "only for use in another shape's `of`"},
           {ShapeRole::water, "water", "filled with water"},
           {ShapeRole::sediment, "sediment", "filled with the sediment named by `material`"},
           {ShapeRole::wall, "wall", "a fixed wall"},
           {ShapeRole::moving_wall, "moving wall", "a wall that moves as the [[motion]] named by `motion` says"},
           {ShapeRole::empty, "empty", "takes away what earlier shapes put there"}}};
}
inline constexpr std::array<Choice<WallSide>, 3> choices(WallSide) {
  return {
      {{WallSide::inside, "inside", "the shape is a solid body in the flow"},
       {WallSide::outside, "outside", "the shape is a container and the wall lies around it"},
       {WallSide::both, "both", "meshes: the surface, open or closed, is a plate; half the wall lies on each side"}}};
}
inline constexpr std::array<Choice<Axis>, 3> choices(Axis) {
  return {{{Axis::x, "x", "the polygon's points are y, z"},
           {Axis::y, "y", "the polygon's points are x, z"},
           {Axis::z, "z", "the polygon's points are x, y"}}};
}
inline constexpr std::array<Choice<BooleanMethod>, 2> choices(BooleanMethod) {
  return {{{BooleanMethod::exact, "exact", "surface meshes are cut against each other with exact arithmetic"},
           {BooleanMethod::voxel, "voxel",
            "lattice points are combined one by one; for surfaces whose exact combination is refused"}}};
}

/// One [[shape]]. Later shapes take the place of earlier ones where they overlap.
struct Shape {
  std::string name;
  ShapeKind kind = ShapeKind::box;
  ShapeRole role = ShapeRole::none;
  Vec3 from = Vec3::Zero();              // [m]
  Vec3 to = Vec3::Zero();                // [m]
  Vec3 center = Vec3::Zero();            // [m]
  double radius = 0;                     // [m]
  double end_radius = 0;                 // [m]
  std::vector<Eigen::Vector2d> polygon;  // [m]
  Axis axis = Axis::y;
  std::vector<double> extent;  // [m]
  std::string file;
  double scale = 1;            // [-]
  std::vector<double> rotate;  // [rad]
  std::vector<double> move;    // [m]
  bool repair = false;
  double base = 0;   // [m]
  double level = 0;  // [m]
  std::vector<std::string> of;
  BooleanMethod boolean = BooleanMethod::exact;
  std::string material;
  std::string motion;
  WallSide side = WallSide::inside;
  std::vector<std::string> open;
  double thickness = 0;  // [m]
  int line = 0;          // where it stands in the case file, for messages; not a key

  template <class V>
  void describe(V& v) {
    v.text("name", name, "Name of the shape, unique in the case.");
    v.choice("kind", kind, "What it is.");
    v.choice("role", role, "What it is made of.");
    v.point("from", from, "m", "box: lower corner; cylinder, cone: one end of the axis.");
    v.point("to", to, "m", "box: upper corner; cylinder, cone: other end of the axis.");
    v.point("center", center, "m", "sphere: its centre; cylinder in 2-D: centre of the disc.");
    v.quantity("radius", radius, "m", 0, 1e6, "sphere, cylinder: the radius; cone: the radius at `from`.");
    v.quantity("end_radius", end_radius, "m", 0, 1e6, "cone: the radius at `to`; 0: a point.");
    v.polygon("polygon", polygon, "m", "prism: corners in order, in the plane across `axis`; 2-D: x, z.");
    v.choice("axis", axis, "prism in 3-D: the direction along which the polygon extends.");
    v.quantities("extent", extent, "m", -1e9, 1e9, "prism in 3-D: where it begins and ends along `axis`.");
    v.text("file", file, "mesh, bathymetry: the file, relative to the case's folder.");
    v.number("scale", scale, 1e-9, 1e9, "mesh, bathymetry: metres in one unit of the file; 0.001 for millimetres.");
    v.quantities("rotate", rotate, "rad", -7, 7,
                 "mesh, bathymetry: three angles by which it is turned about the x, then the y, then the z axis.");
    v.quantities("move", move, "m", -1e9, 1e9,
                 "mesh, bathymetry: three distances by which it is moved in x, y, z, after scaling and turning.");
    v.flag("repair", repair,
           "mesh, bathymetry: stitch gaps, turn faces alike and fill small holes, and say so; else such a file is "
           "refused.");
    v.quantity("base", base, "m", -1e9, 1e9, "bathymetry: the height down to which the body reaches.");
    v.quantity("level", level, "m", -1e9, 1e9, "level: the height up to which the containers are filled.");
    v.texts("of", of, "union, difference, intersection: names of the shapes combined.");
    v.choice("boolean", boolean, "union, difference, intersection with a mesh among their shapes: how to combine.");
    v.text("material", material, "role = \"sediment\": name of the material; may be left out when there is only one.");
    v.text("motion", motion, "role = \"moving wall\": name of its [[motion]]; shapes with the same one move together.");
    v.choice("side", side, "Walls: which side of the surface is wall.");
    v.texts("open", open,
            "Container walls (side = \"outside\") of a box: faces without wall, any of \"-x\", \"+x\", \"-y\", \"+y\", "
            "\"-z\", \"+z\".");
    v.quantity("thickness", thickness, "m", 0, 1e6,
               "layer: height above the floor. Walls: thickness; default: as much as the kernel's support needs.");
  }
};

enum class MotionKind { piecewise_linear, rotation, gate_lift, oscillation };

inline constexpr std::array<Choice<MotionKind>, 4> choices(MotionKind) {
  return {{{MotionKind::piecewise_linear, "piecewise linear",
            "along `direction` by `displacements` at `times`, or by the table in `file`; at rest before and after"},
           {MotionKind::rotation, "rotation",
            "about `axis` through `center`, from `start` on with `angular_speed`, or by `angles` at `times`, or by the "
            "table in `file`"},
           {MotionKind::gate_lift, "gate lift",
            "along `direction` from `start` on, with `speed` at once, or with `acceleration` until it has `speed` (for "
            "ever without `speed`); stops after `distance`"},
           {MotionKind::oscillation, "oscillation",
            "along `direction` from `start` on by amplitude (1 - cos(2 pi t/period)): from rest at one end of a stroke "
            "of twice the amplitude"}}};
}

/// One [[motion]]: how moving walls move. At t = 0 they are where their shapes put them, whatever a table says there.
struct Motion {
  std::string name;
  MotionKind kind = MotionKind::piecewise_linear;
  Vec3 direction = Vec3::Zero();      // [-]
  std::vector<double> times;          // [s]
  std::vector<double> displacements;  // [m]
  std::vector<double> angles;         // [rad]
  std::string file;
  Vec3 center = Vec3::Zero();  // [m]
  Vec3 axis = Vec3::Zero();    // [-]
  double angular_speed = 0;    // [rad/s]
  double start = 0;            // [s]
  double speed = 0;            // [m/s]
  double acceleration = 0;     // [m/s^2]
  double distance = 0;         // [m]
  double amplitude = 0;        // [m]
  double period = 0;           // [s]

  template <class V>
  void describe(V& v) {
    v.text("name", name, "Name of the motion, unique in the case.");
    v.choice("kind", kind, "How it goes.");
    v.direction("direction", direction, "piecewise linear, gate lift, oscillation: where to; any length.");
    v.quantities("times", times, "s", 0, 1e9, "piecewise linear, rotation: times of the table, increasing.");
    v.quantities("displacements", displacements, "m", -1e6, 1e6,
                 "piecewise linear: way along `direction` at `times`, counted from the one at t = 0.");
    v.quantities("angles", angles, "rad", -1e6, 1e6,
                 "rotation: angle about `axis` at `times`, counted from the one at t = 0.");
    v.text(
        "file", file,
        "piecewise linear, rotation: the table as CSV, relative to the case's folder: time [s], and displacement [m] "
        "or angle [rad] or angle [deg].");
    v.point("center", center, "m", "rotation: a point on the axis (the hinge of a flap).");
    v.direction(
        "axis", axis,
        "rotation in 3-D: direction of the axis, turned about by the right-hand rule; in 2-D angles are counted "
        "counter-clockwise, x to the right and z upwards.");
    v.quantity("angular_speed", angular_speed, "rad/s", -1e6, 1e6, "rotation: angle per time, without a table.");
    v.quantity("start", start, "s", 0, 1e9, "gate lift, oscillation, rotation with angular_speed: when it begins.");
    v.quantity("speed", speed, "m/s", 0, 1e4, "gate lift: final speed; 0: as `acceleration` has it.");
    v.quantity("acceleration", acceleration, "m/s^2", 0, 1e6, "gate lift: how fast it gets there; 0: at once.");
    v.quantity("distance", distance, "m", 0, 1e6, "gate lift: after which it stops at once; 0: never.");
    v.quantity("amplitude", amplitude, "m", 0, 1e6, "oscillation: half the stroke.");
    v.quantity("period", period, "s", 0, 1e9, "oscillation: time of one to and fro.");
  }
};

enum class LatticeAnchor { walls, domain, point };

inline constexpr std::array<Choice<LatticeAnchor>, 3> choices(LatticeAnchor) {
  return {
      {{LatticeAnchor::walls, "walls",
        "the lower corner of the first container, so that flat walls stand half a spacing from the first particles; "
        "the domain's without a container"},
       {LatticeAnchor::domain, "domain", "the lower corner of the domain"},
       {LatticeAnchor::point, "point", "`anchor_point`"}}};
}

/// How shapes become particles.
struct GencaseParameters {
  LatticeAnchor anchor = LatticeAnchor::walls;
  Vec3 anchor_point = Vec3::Zero();  // [m]
  int relaxation = 0;

  template <class V>
  void describe(V& v) {
    v.choice("anchor", anchor,
             "What the lattice of particles is aligned with: particles stand half a spacing from it.");
    v.point("anchor_point", anchor_point, "m", "anchor = \"point\": a corner of the lattice's cells.");
    v.integer(
        "relaxation", relaxation, 0, 1000,
        "Largest number of sweeps that fit fluid to curved walls: half a spacing from them, and evenly; 0: leave the "
        "lattice.");
  }
};

struct WaterParameters {
  double density = 1000;    // [kg/m^3]
  double viscosity = 1e-3;  // [Pa s]

  template <class V>
  void describe(V& v) {
    v.quantity("density", density, "kg/m^3", 1, 20000, "Density at rest, at the surface.");
    v.quantity("viscosity", viscosity, "Pa s", 0, 1e3, "Dynamic viscosity.");
  }
};

enum class SedimentModel { off, viscoplastic, three_state };
enum class Implementation { consistent, paper };
enum class WallFriction { none, smooth };
enum class SeepageModel { off, mixture };
enum class PorePressureModel { off, diffusion };

inline constexpr std::array<Choice<SeepageModel>, 2> choices(SeepageModel) {
  return {{{SeepageModel::off, "off", "the bed is one fluid, into which no water seeps"},
           {SeepageModel::mixture, "mixture",
            "grains and pore water are two sets of particles in the same places, joined by Ergun's drag"}}};
}
inline constexpr std::array<Choice<PorePressureModel>, 2> choices(PorePressureModel) {
  return {{{PorePressureModel::off, "off", "the bed drains at once"},
           {PorePressureModel::diffusion, "diffusion",
            "excess pore pressure rises as the bed is compressed, drains by consolidation and weakens the bed"}}};
}

inline constexpr std::array<Choice<WallFriction>, 2> choices(WallFriction) {
  return {{{WallFriction::none, "none", "water slips along walls"},
           {WallFriction::smooth, "smooth", "shear stress of a smooth wall's turbulent boundary layer (Blasius)"}}};
}

inline constexpr std::array<Choice<SedimentModel>, 3> choices(SedimentModel) {
  return {
      {{SedimentModel::off, "off", "no sediment in the scene"},
       {SedimentModel::viscoplastic, "viscoplastic",
        "Herschel-Bulkley-Papanastasiou fluid with Drucker-Prager yield under submerged weight"},
       {SedimentModel::three_state, "three-state",
        "the same as deposit, and as bed load and in suspension where the water's shear stress moves its surface"}}};
}
inline constexpr std::array<Choice<Implementation>, 2> choices(Implementation) {
  return {{{Implementation::consistent, "consistent", "the physics the source paper means, misprints mended"},
           {Implementation::paper, "paper",
            "the equations as the source paper prints them; `thalweg explain sediment` tells the differences"}}};
}
inline constexpr std::array<Choice<BedShear>, 3> choices(BedShear) {
  return {
      {{BedShear::log_law, "log-law", "logarithmic law, from the mean of the water in reach"},
       {BedShear::nearest, "nearest", "logarithmic law, from the water particle nearest to the grain"},
       {BedShear::paper, "paper", "rho (kappa du/2)^2 from the summed velocity difference, the paper's (20), (21)"}}};
}
inline constexpr std::array<Choice<EffectivePressure>, 3> choices(EffectivePressure) {
  return {{{EffectivePressure::column, "column", "weight under water of the sediment above, column by column"},
           {EffectivePressure::laplace, "laplace", "Laplace's equation in the bed, one layer's weight at its surface"},
           {EffectivePressure::eos, "eos",
            "(1 - pore density / bed density) of the pressure: strength at the very surface; for comparison"}}};
}
inline constexpr std::array<Choice<YieldCriterion>, 2> choices(YieldCriterion) {
  return {{{YieldCriterion::drucker_prager, "drucker-prager", "a cone; yield_fit says which"},
           {YieldCriterion::mohr_coulomb, "mohr-coulomb", "Mohr-Coulomb by the Lode angle of the rate of strain"}}};
}
inline constexpr std::array<Choice<Rheology>, 2> choices(Rheology) {
  return {{{Rheology::herschel_bulkley, "herschel-bulkley", "yield stress, consistency and flow index"},
           {Rheology::mu_of_i, "mu-of-i", "friction that grows with the inertial number; consistency of the pores"}}};
}
inline constexpr std::array<Choice<ViscosityTreatment>, 3> choices(ViscosityTreatment) {
  return {{{ViscosityTreatment::implicit, "implicit", "solved for at the end of the step"},
           {ViscosityTreatment::explicit_steps, "explicit", "explicit, with steps 50 to 400 times shorter"},
           {ViscosityTreatment::capped, "capped",
            "explicit, the viscosity cut to what the acoustic step can take: the bed creeps"}}};
}
inline constexpr std::array<Choice<YieldFit>, 6> choices(YieldFit) {
  return {{{YieldFit::sine, "sin", "sin(phi): plane strain without dilation, for flumes and 2-D"},
           {YieldFit::coulomb, "coulomb", "tan(phi): slip along the shear plane; a slope stands up to phi"},
           {YieldFit::outer, "outer", "6 sin(phi) / (sqrt3 (3 - sin(phi))): outer cone of Mohr-Coulomb"},
           {YieldFit::inner, "inner", "6 sin(phi) / (sqrt3 (3 + sin(phi))): inner cone"},
           {YieldFit::plane_strain, "plane-strain",
            "3 tan(phi) / sqrt(9 + 12 tan^2(phi)): plane strain, dilation = friction"},
           {YieldFit::paper, "paper", "2 sin(phi) / (sqrt3 (3 - sin(phi))): the coefficient as the paper prints it"}}};
}

struct Model {
  SedimentModel sediment = SedimentModel::off;
  Implementation implementation = Implementation::consistent;
  EffectivePressure effective_pressure = EffectivePressure::column;
  YieldCriterion yield = YieldCriterion::drucker_prager;
  YieldFit yield_fit = YieldFit::sine;
  Rheology rheology = Rheology::herschel_bulkley;
  BedShear bed_shear = BedShear::log_law;
  bool rest = true;
  WallFriction wall_friction = WallFriction::none;
  SeepageModel seepage = SeepageModel::off;
  PorePressureModel pore_pressure = PorePressureModel::off;

  /// How the friction angle becomes the coefficient in plane strain; Mohr-Coulomb has one answer.
  [[nodiscard]] YieldFit plane_strain_fit() const {
    return yield == YieldCriterion::mohr_coulomb ? YieldFit::sine : yield_fit;
  }

  template <class V>
  void describe(V& v) {
    v.choice("sediment", sediment, "How sediment moves.");
    v.choice(
        "implementation", implementation,
        "Which reading of the source paper: sets the defaults of yield_fit, bed_shear, consistency and flow_index, "
        "and how states change.");
    v.choice("wall_friction", wall_friction,
             "What water feels of the walls it runs along; sediment always sticks to walls.");
    v.choice("effective_pressure", effective_pressure, "What presses the sediment's grains together.");
    v.choice("yield", yield, "When the sediment yields.");
    v.choice("yield_fit", yield_fit,
             "How the friction angle becomes the pressure coefficient of the Drucker-Prager yield stress.");
    v.choice("rheology", rheology, "How yielded sediment flows.");
    v.choice("bed_shear", bed_shear, "How the water's shear stress on the bed is found (three-state).");
    v.flag("rest", rest,
           "Sediment that has been below yield for a while, with nothing moving about it, stops exactly and costs next "
           "to nothing until something wakes it.");
    v.choice("seepage", seepage, "Whether water moves through the bed (docs/theory.md).");
    v.choice("pore_pressure", pore_pressure, "Excess pore pressure in a bed of one fluid (docs/theory.md).");
  }
};

/// The precision of the sums over pairs; that of what is kept of a particle is the same in both.
enum class Precision { single_sums, double_sums };

inline constexpr std::array<Choice<Precision>, 2> choices(Precision) {
  return {{{Precision::single_sums, "single", "32 bits; distances are exact first"},
           {Precision::double_sums, "double",
            "64 bits, on CPU cores only: to see what single precision costs in accuracy and gains in time"}}};
}

/// How exact a run is to be where the case does not say it key by key; numerics_at() says what follows.
enum class Accuracy { draft, standard, fine };

inline constexpr std::array<Choice<Accuracy>, 3> choices(Accuracy) {
  return {{{Accuracy::draft, "draft", "cfl = 0.7, sound_speed_factor = 7"},
           {Accuracy::standard, "standard", "the defaults of this table"},
           {Accuracy::fine, "fine", "sound_speed_factor = 20"}}};
}

enum class Integrator { leapfrog, two_pass };

inline constexpr std::array<Choice<Integrator>, 2> choices(Integrator) {
  return {{{Integrator::leapfrog, "leapfrog", "accelerations and density rates once a step, half a step apart"},
           {Integrator::two_pass, "two-pass", "the midpoint rule: both twice a step; for comparison"}}};
}

struct Numerics {
  Accuracy accuracy = Accuracy::standard;
  double spacing = required;           // [m]
  double smoothing_ratio = 1.5;        // [-] h / spacing
  double sound_speed_factor = 10;      // [-]
  double maximum_speed = 0;            // [m/s]; 0: 2 sqrt(g H)
  double cfl = 0.5;                    // [-]
  double density_diffusion = 0.1;      // [-]
  double artificial_viscosity = 0.02;  // [-]
  ViscosityTreatment viscosity = ViscosityTreatment::implicit;
  double viscous_tolerance = 1e-3;  // [-]
  int viscous_iterations = 1000;
  double list_skin = 0.15;       // [-]
  double excluded_limit = 1e-3;  // [-]
  Precision precision = Precision::single_sums;
  Integrator integrator = Integrator::leapfrog;

  template <class V>
  void describe(V& v) {
    v.choice("accuracy", accuracy,
             "Sets the defaults of other keys of this table; what each level costs and gives is measured in "
             "docs/speed-against-error.md. The spacing decides more than any of them.");
    v.quantity("spacing", spacing, "m", 1e-6, 100, "Distance of the particles at the start (dp).");
    v.number("smoothing_ratio", smoothing_ratio, 1.1, 3,
             "Smoothing length over spacing; 1.3 is no cheaper in the plane than 1.5, and less exact "
             "(docs/speed-against-error.md).");
    v.number("sound_speed_factor", sound_speed_factor, 5, 100,
             "Sound speed over maximum_speed; 10 keeps density within 1 %.");
    v.quantity("maximum_speed", maximum_speed, "m/s", 0, 1000,
               "Largest speed expected, from which the sound speed follows; 0: 2 sqrt(g H), H the height of the fluid "
               "at the start.");
    v.number(
        "cfl", cfl, 0.01, 100,
        "Courant number of the acoustic and force time steps; errors do not depend on it up to 1.0 "
        "(docs/speed-against-error.md), but near 0.7 splashes begin to gain energy; at 2 a run diverges and says so.");
    v.number("density_diffusion", density_diffusion, 0, 1, "Delta of the density diffusion (Fourtakas et al. 2019).");
    v.number("artificial_viscosity", artificial_viscosity, 0, 1,
             "Alpha of the artificial viscosity between approaching particles of one phase.");
    v.choice("viscosity", viscosity, "How the viscosity of the sediment is advanced in time.");
    v.number("viscous_tolerance", viscous_tolerance, 1e-8, 0.1,
             "Residual at which the implicit viscosity stops, over the momentum one step of gravity gives.");
    v.integer("viscous_iterations", viscous_iterations, 1, 1000000,
              "Iterations after which the implicit viscosity tries again with less, and in the end stops the run.");
    v.number("list_skin", list_skin, 0, 1,
             "Reach of the neighbour list beyond the kernel's support, over the support.");
    v.number("excluded_limit", excluded_limit, 0, 1,
             "Share of the fluid particles that may leave the domain before the run stops with an error.");
    v.choice("precision", precision, "Precision in which a particle's sums over its neighbours are computed.");
    v.choice("integrator", integrator, "How a step in time is made.");
  }
};

/// The defaults of the numerics at a level of accuracy.
Numerics numerics_at(Accuracy accuracy);

struct Output {
  double end = required;        // [s]
  double interval = 0;          // [s]
  std::vector<double> times;    // [s]
  double history_interval = 0;  // [s]
  double gauge_interval = 0;    // [s]

  template <class V>
  void describe(V& v) {
    v.quantity("end", end, "s", 0, 1e9, "Physical time at which the run ends.");
    v.quantity("interval", interval, "s", 0, 1e9, "Time between snapshots; 0: only at `times`, the start and the end.");
    v.quantities("times", times, "s", 0, 1e9, "Further times at which a snapshot is written, hit exactly.");
    v.quantity("history_interval", history_interval, "s", 0, 1e9,
               "Time between rows of history.csv; 0: a hundredth of the run.");
    v.quantity("gauge_interval", gauge_interval, "s", 0, 1e9,
               "Time between rows of gauges.csv; 0: a thousandth of the run.");
  }
};

enum class GaugeKind { water_level, pressure, velocity, flux };

inline constexpr std::array<Choice<GaugeKind>, 4> choices(GaugeKind) {
  return {{{GaugeKind::water_level, "water level", "height of the free surface, and of the bed, over `at`"},
           {GaugeKind::pressure, "pressure", "of the fluid at `at`"},
           {GaugeKind::velocity, "velocity", "of the fluid at `at`"},
           {GaugeKind::flux, "flux",
            "volumes of water and of sediment, pores included, that cross the rectangle between `from` and `to` in a "
            "second, counted along the axis"}}};
}

/// One [[gauge]]: what is measured during the run, without snapshots.
struct Gauge {
  std::string name;
  GaugeKind kind = GaugeKind::water_level;
  Vec3 at = Vec3::Zero();    // [m]
  Vec3 from = Vec3::Zero();  // [m]
  Vec3 to = Vec3::Zero();    // [m]

  template <class V>
  void describe(V& v) {
    v.text("name", name, "Name of the gauge, unique in the case; heads its columns in gauges.csv.");
    v.choice("kind", kind, "What it measures.");
    v.point("at", at, "m", "water level, pressure, velocity: where; of a water level the height means nothing.");
    v.point("from", from, "m", "flux: one corner of a rectangle across an axis.");
    v.point("to", to, "m", "flux: the opposite corner, equal to `from` along that axis.");
  }
};

/// One [[line]]: where profiles are taken beside the one along x.
struct ProfileLine {
  std::string name;
  std::vector<double> from;  // [m] x, y
  std::vector<double> to;    // [m] x, y

  template <class V>
  void describe(V& v) {
    v.text("name", name, "Name of the line, unique in the case; names its folder in profiles/.");
    v.quantities("from", from, "m", -1e9, 1e9, "Its start in plan: x, y.");
    v.quantities("to", to, "m", -1e9, 1e9, "Its end in plan: x, y.");
  }
};

struct Compare {
  std::vector<double> times;  // [s]
  std::vector<std::string> references;
  double from = 0;  // [m]
  double to = 0;    // [m]
  int runs = 1;

  template <class V>
  void describe(V& v) {
    v.quantities("times", times, "s", 0, 1e9,
                 "Times at which profiles are extracted and compared; snapshots are written there too.");
    v.texts("references", references, "Folders with measured profiles (t0.250.csv …), relative to the case.");
    v.quantity("from", from, "m", -1e9, 1e9, "Start of the range compared; with `to` equal: the whole domain.");
    v.quantity("to", to, "m", -1e9, 1e9, "End of the range compared.");
    v.integer("runs", runs, 1, 4,
              "Particle runs that `thalweg run` makes, each with twice the spacing of the one before: what the spacing "
              "decides, and what it costs.");
  }
};

/// What foam.models and `thalweg foam --model` may name; foam_reference/foam_model.hpp says what they are.
inline constexpr std::array<const char*, 3> mesh_model_names{"same-material", "eroding-bed", "stock"};

enum class FoamTurbulence { laminar, smagorinsky };

inline constexpr std::array<Choice<FoamTurbulence>, 2> choices(FoamTurbulence) {
  return {{{FoamTurbulence::laminar, "laminar", "none, as in the particle model"},
           {FoamTurbulence::smagorinsky, "smagorinsky", "large eddies with Smagorinsky's model, in all phases"}}};
}
inline constexpr std::array<Choice<BedLoad>, 2> choices(BedLoad) {
  return {{{BedLoad::meyer_peter_mueller, "meyer-peter-mueller", "8 (theta - theta_cr)^1.5"},
           {BedLoad::van_rijn, "van-rijn", "0.053 (theta/theta_cr - 1)^2.1 / d*^0.3, for sands"}}};
}
inline constexpr std::array<Choice<PickUp>, 2> choices(PickUp) {
  return {{{PickUp::mastbergen, "mastbergen", "the lift velocity of Mastbergen & van den Berg"},
           {PickUp::van_rijn, "van-rijn", "van Rijn's pick-up function, for sands"}}};
}

struct Foam {
  std::vector<std::string> models;  // empty: all that fit the scene
  double cell = 0;                  // [m]
  int meshes = 2;
  double open_above = 0;  // [m]
  FoamTurbulence turbulence = FoamTurbulence::laminar;
  BedLoad bed_load = BedLoad::meyer_peter_mueller;
  PickUp pick_up = PickUp::mastbergen;

  template <class V>
  void describe(V& v) {
    v.texts(
        "models", models,
        "Mesh models to run: \"same-material\", \"eroding-bed\", \"stock\" (foam_reference/README.md). Default: the "
        "first two where the scene has sediment.");
    v.quantity("cell", cell, "m", 0, 100, "Cell size of the mesh model; 0: twice the particle spacing.");
    v.integer("meshes", meshes, 1, 4,
              "Meshes each model runs on, each twice as coarse as the one before; their difference is shown as the "
              "mesh model's uncertainty.");
    v.quantity("open_above", open_above, "m", 0, 1e6,
               "Height of air above the fluid's highest point in the mesh model; 0: half the fluid's height.");
    v.choice("turbulence", turbulence, "Turbulence of the mesh model.");
    v.choice("bed_load", bed_load, "What carries grains along the bed in \"eroding-bed\".");
    v.choice("pick_up", pick_up, "What brings grains into suspension in \"eroding-bed\".");
  }
};

/// A whole case, checked: every value in range, every name known, every unit right.
struct Case {
  std::filesystem::path folder;  // of the case file, for what it refers to
  std::filesystem::path file;
  CaseInfo info;
  Domain domain;
  std::vector<Shape> shapes;
  std::vector<Motion> motions;
  /// Contents of the files that shapes name, as hashes by their names: what tells one mesh from another in hash_of().
  std::map<std::string, std::string> file_hashes;
  GencaseParameters gencase;
  WaterParameters water;
  std::map<std::string, SedimentParameters> sediments;  // [materials.<name>] other than water
  Model model;
  Numerics numerics;
  Output output;
  std::vector<Gauge> gauges;
  std::vector<ProfileLine> lines;
  Compare compare;
  Foam foam;

  [[nodiscard]] double smoothing_length() const { return numerics.smoothing_ratio * numerics.spacing; }
  [[nodiscard]] bool has_sediment() const;
  /// The one sediment of the scene; throws InputError when there is none or more than one.
  [[nodiscard]] const SedimentParameters& sediment() const;
};

}  // namespace thalweg
