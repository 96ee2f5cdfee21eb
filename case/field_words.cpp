#include "case/field_words.hpp"

#include <algorithm>
#include <cctype>

namespace thalweg {
namespace {

std::string normal(std::string_view word) {
  std::string text;
  for (const char c : word) {
    if (c == '-' || c == '_') {
      text += ' ';
    } else {
      text += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return text;
}

bool is_meant(std::string_view word, const std::string& known) {
  return word == known || word == known + "s" || known == std::string(word) + "s";
}

}  // namespace

const std::vector<FieldWord>& field_words() {
  static const std::vector<FieldWord> all{
      {{"inflow", "upstream", "inlet boundary", "hydrograph", "pump", "feed water"},
       "Water comes in through an [[inlet]]: an opening with a velocity, a discharge or a table of times "
       "(docs/openings.md).",
       {"inlet"}},
      {{"outflow", "downstream", "drain", "outlet boundary", "free outfall", "tailwater", "tail water",
        "open boundary"},
       "Water leaves through an [[outlet]]: it falls away, or meets water of a given level (docs/openings.md).",
       {"outlet"}},
      {{"scour depth", "scour", "scour hole", "erosion depth", "scour volume", "bed change", "erosion"},
       "A result, not a key: thalweg postproc measures how far the bed has sunk below its start (report, profiles/ and "
       "surfaces/; docs/file-formats.md). thalweg formulas CASE gives the depths of handbooks. The keys below decide "
       "how sediment moves.",
       {"model.sediment", "model.bed_load", "surface_bed.factor", "compare.times"}},
      {{"slope", "bed slope", "incline", "gradient", "fall of the flume", "tilt"},
       "A flume's fall drives a current through [flow] slope in a periodic domain. A sloping bed is a shape: a prism "
       "with a polygon, or a bathymetry.",
       {"flow.drive", "flow.slope", "shape.polygon"}},
      {{"current", "steady current", "steady flow", "river", "mean velocity", "flow velocity"},
       "A steady current is driven around a periodic domain by [flow], or runs between an [[inlet]] and an [[outlet]].",
       {"flow.drive", "flow.velocity", "flow.discharge", "inlet.velocity"}},
      {{"reflected waves", "wave reflection", "reflection", "absorbing boundary", "radiation", "seiche", "sloshing"},
       "A fixed discharge throws long waves back. An inlet that follows the scene's level can let them out; an outlet "
       "with a level gives way to them by itself.",
       {"inlet.absorbs_waves", "inlet.surface", "outlet.kind"}},
      {{"initial velocity", "start velocity", "initial condition"},
       "Water starts at rest unless flow.start says otherwise.",
       {"flow.start", "flow.start_of"}},
      {{"roughness height", "ks", "k s", "manning", "nikuradse", "bottom friction", "wall roughness", "bed roughness"},
       "Roughness is Nikuradse's sand-grain height in metres, of walls, of the bed, and of an inlet's velocity "
       "profile.",
       {"shape.roughness", "materials.<sediment>.roughness", "inlet.roughness", "model.wall_friction"}},
      {{"grain size", "d50", "grain", "sand", "gravel", "particle diameter"},
       "The bed's grains are described in [materials.NAME]; the shape with role = \"sediment\" is made of them.",
       {"materials.<sediment>.grain_diameter", "materials.<sediment>.grain_density"}},
      {{"shields", "shields number", "shields parameter", "critical shear stress", "threshold", "incipient motion",
        "threshold of motion"},
       "Grains move where the water's shear stress is above the critical Shields number of their size, or above a "
       "measured stress.",
       {"materials.<sediment>.critical_shields", "materials.<sediment>.critical_stress", "model.bed_shear"}},
      {{"bedload", "transport", "sediment transport", "transport rate", "meyer peter mueller"},
       "Grains that roll along the bed follow a transport law (model.bed_load), which model.sediment = \"three-state\" "
       "and \"surface\" use.",
       {"model.sediment", "model.bed_load"}},
      {{"suspension", "suspended sediment", "suspended", "concentration", "turbidity", "settling", "settling velocity"},
       "Grains in suspension are carried by sediment particles or as a concentration in the water; an inlet can bring "
       "them.",
       {"suspended_load.carried_by", "suspended_load.pick_up", "inlet.grains"}},
      {{"angle of repose", "internal friction", "friction coefficient", "phi"},
       "The bed yields by friction under its submerged weight.",
       {"materials.<sediment>.friction_angle", "model.yield"}},
      {{"packing", "solid fraction", "void ratio", "bulk density"},
       "The share of pores gives the density of the bed; a measured bulk density may be given in its place.",
       {"materials.<sediment>.porosity", "materials.<sediment>.bed_density"}},
      {{"morphological factor", "morfac", "long time", "equilibrium scour", "hours", "days"},
       "Scour that takes minutes to days is computed with the bed as a surface, whose time runs faster than the "
       "water's (docs/surface-bed.md).",
       {"surface_bed.factor", "surface_bed.window", "surface_bed.spin_up"}},
      {{"gate", "sluice", "moving wall", "piston", "wave maker", "wavemaker", "paddle", "wave"},
       "A wall that moves is a shape with role = \"moving wall\" and a [[motion]]: a gate that lifts, a piston, a "
       "flap.",
       {"motion.kind", "shape.motion"}},
      {{"pier", "pile", "pipe", "pipeline", "abutment", "weir", "wall", "obstacle", "structure", "stl", "obj", "cad"},
       "A structure is a shape with role = \"wall\": a box, a cylinder, a prism, or a mesh from a file "
       "(docs/geometry.md).",
       {"shape.kind", "shape.role", "shape.file"}},
      {{"survey", "terrain", "dem", "bathymetry file", "river bed"},
       "A surveyed bed is a shape of kind \"bathymetry\", read from CSV, XYZ or an ESRI grid (docs/geometry.md).",
       {"shape.kind", "shape.file", "shape.base"}},
      {{"probe", "sensor", "wave gauge", "water level", "pressure sensor", "velocity sensor", "measurement point"},
       "A [[gauge]] writes a column of gauges.csv at every time: water level, pressure, velocity, flux.",
       {"gauge.kind", "gauge.at", "output.gauge_interval"}},
      {{"duration", "end time", "simulation time", "run time", "stop time", "t end"},
       "The run ends at output.end.",
       {"output.end"}},
      {{"snapshot", "output interval", "save", "time step of output"},
       "Snapshots of all particles are written every output.interval, and at the times named.",
       {"output.interval", "output.times"}},
      {{"time step", "dt", "courant", "courant number"},
       "The time step follows from the sound speed, the forces and numerics.cfl.",
       {"numerics.cfl", "numerics.sound_speed_factor"}},
      {{"resolution", "dp", "particle size", "particle spacing", "mesh size", "grid", "cell size"},
       "Particles stand numerics.spacing apart at the start; foam.cell is the mesh model's cell. Half the spacing "
       "costs about 8 times the time in 2-D, 16 times in 3-D.",
       {"numerics.spacing", "foam.cell", "numerics.accuracy"}},
      {{"eddy", "eddy viscosity", "les", "smagorinsky", "mixing length"},
       "Eddies that the particles are too coarse for are modelled by model.turbulence; foam.turbulence is the mesh "
       "model's.",
       {"model.turbulence", "foam.turbulence"}},
      {{"boundary", "boundary condition", "symmetry", "no slip", "free slip", "periodic boundary"},
       "Walls are shapes; domain.periodic lets opposite sides meet; [[inlet]] and [[outlet]] are openings.",
       {"shape.role", "model.wall_friction", "domain.periodic"}},
      {{"openfoam", "vof", "mesh model", "cfd"},
       "The same scene on a mesh, for comparison, by OpenFOAM.",
       {"foam.models", "foam.cell", "foam.meshes"}},
      {{"experiment", "measurement", "reference data", "validation"},
       "Measured profiles are compared with the run's at the times of [compare].",
       {"compare.references", "compare.times"}},
      {{"mud", "clay", "silt", "cohesive"},
       "A cohesive bed has a cohesion and a measured critical stress.",
       {"materials.<sediment>.cohesion", "materials.<sediment>.critical_stress"}},
  };
  return all;
}

const FieldWord* find_field_word(std::string_view word) {
  const std::string asked = normal(word);
  for (const FieldWord& entry : field_words()) {
    for (const std::string& known : entry.words)
      if (is_meant(asked, known)) return &entry;
  }
  return nullptr;
}

}  // namespace thalweg
