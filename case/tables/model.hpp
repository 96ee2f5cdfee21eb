#pragma once

#include <iosfwd>
#include <string_view>

#include "case/models/bed_load.hpp"
#include "case/models/bed_strength.hpp"
#include "case/models/implementation.hpp"
#include "case/models/mixture.hpp"
#include "case/models/pore_pressure.hpp"
#include "case/models/sediment_motion.hpp"
#include "case/models/three_state.hpp"
#include "case/models/turbulence.hpp"
#include "case/models/wall_friction.hpp"
#include "case/tables/table.hpp"

namespace thalweg {

/// [model]: the physics beyond water between walls.
struct Model {
  static constexpr TableHeading heading{"model", "What the scene needs; off unless named."};

  SedimentModel sediment = SedimentModel::off;
  Implementation implementation = Implementation::law;
  EffectivePressure effective_pressure = EffectivePressure::column;
  YieldCriterion yield = YieldCriterion::drucker_prager;
  YieldFit yield_fit = YieldFit::sine;
  Rheology rheology = Rheology::herschel_bulkley;
  BedShear bed_shear = BedShear::log_law;
  BedLoad bed_load = BedLoad::meyer_peter_mueller;
  SlopeEffect slope_effect = SlopeEffect::friction;
  SurfaceHold bed_surface = SurfaceHold::free;
  bool rest = true;
  WallFriction wall_friction = WallFriction::none;
  Turbulence turbulence = Turbulence::off;
  SeepageModel seepage = SeepageModel::off;
  PorePressureModel pore_pressure = PorePressureModel::off;
  bool thin_films = false;

  template <class V>
  void describe(V& v) {
    v.choice("sediment", sediment, "How sediment moves.");
    v.choice(
        "implementation", implementation,
        "How three-state sediment moves: by laws that were measured, or by one of two readings of the source paper. "
        "Sets the defaults of yield_fit, bed_shear, consistency and flow_index, and how states change.");
    v.choice(
        "wall_friction", wall_friction,
        "What water feels of the walls it runs along; sediment always sticks to walls. Where it is not given it is "
        "\"smooth\" in driven flows ([flow]).");
    v.choice("turbulence", turbulence,
             "Eddies of the water that the particles are too coarse for. Walls and sediment take no part "
             "(docs/theory.md). Where it is not given it is \"mixing-length\" in driven flows ([flow]).");
    v.choice("effective_pressure", effective_pressure, "What presses the sediment's grains together.");
    v.choice("yield", yield, "When the sediment yields.");
    v.choice("yield_fit", yield_fit,
             "How the friction angle becomes the pressure coefficient of the Drucker-Prager yield stress.");
    v.choice("rheology", rheology, "How yielded sediment flows.");
    v.choice("bed_shear", bed_shear, "How the water's shear stress on the bed is found (three-state).");
    v.choice("bed_load", bed_load, "How fast grains move along the bed (three-state, implementation = \"law\").");
    v.choice("slope_effect", slope_effect, "What the bed's slope along the flow changes in its bed load.");
    v.choice(
        "bed_surface", bed_surface,
        "What the pressure of water does to the particles of a bed's surface (three-state, implementation = "
        "\"law\"). Where it is not given it is \"held\" in driven flows ([flow]) and with inlets; write \"held\" for a "
        "current that decays or turns, too.");
    v.flag("rest", rest,
           "Sediment that has been below yield for a while, with nothing moving about it, stops exactly and costs next "
           "to nothing until something wakes it.");
    v.choice("seepage", seepage, "Whether water moves through the bed (docs/theory.md).");
    v.choice("pore_pressure", pore_pressure, "Excess pore pressure in a bed of one fluid (docs/theory.md).");
    v.flag("thin_films", thin_films,
           "Water one particle deep on a wall gets thinner where it is stretched, and its middle stays at half of its "
           "depth. Without it such water sinks through the wall (docs/theory.md): for waves over dry floors at coarse "
           "spacings.");
  }

  /// implementation = "paper" and a driven flow set the defaults of other keys.
  void set_defaults(const GivenWords& given);
  void check(const Case& whole, const CheckContext& at) const;
  static void explain_further(std::ostream& to, std::string_view key);
};

}  // namespace thalweg
