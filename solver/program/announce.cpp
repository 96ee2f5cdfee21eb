#include "solver/program/announce.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>

#include "case/models/surface_bed.hpp"
#include "common/units.hpp"
#include "solver/simulation/start.hpp"

namespace thalweg {
namespace {

void announce_seepage(const Case& c) {
  if (c.model.seepage == SeepageModel::mixture) {
    spdlog::info("model.seepage = mixture: the bed is grains and pore water, joined by Ergun's drag");
  }
  if (c.model.pore_pressure == PorePressureModel::diffusion) {
    spdlog::info("model.pore_pressure = diffusion: excess pore pressure weakens the bed");
  }
}

/// Tells the meaning of a choice.
template <class Word>
void announce(const char* key, const Word& choice) {
  for (const auto& word : choices(choice)) {
    if (word.value == choice) spdlog::info("{} = \"{}\": {}", key, word.name, word.sentence);
  }
}

/// The same if the choice is not the usual one.
template <class Word>
void announce(const char* key, const Word& choice, const Word& usual) {
  if (choice != usual) announce(key, choice);
}

/// Tells which choices of the sediment's model are not the defaults.
void announce_sediment(const Case& c) {
  announce("model.sediment", c.model.sediment, SedimentModel::viscoplastic);
  announce("model.implementation", c.model.implementation, Model{}.implementation);
  announce("model.effective_pressure", c.model.effective_pressure, Model{}.effective_pressure);
  announce("model.yield", c.model.yield, Model{}.yield);
  announce("model.rheology", c.model.rheology, Model{}.rheology);
  if (models::SurfaceBedOfCase::is_on(c)) {
    announce("model.bed_load", c.model.bed_load);
    spdlog::info(
        "surface_bed: steps of at most {:g} spacings, factor at most {:g}; history.csv has bed_time and levels",
        c.surface_bed.step, c.surface_bed.factor);
    return;
  }
  if (c.model.sediment == SedimentModel::three_state) {
    announce("suspended_load.carried_by", c.suspended_load.carried_by, CarriedBy::parcels);
    announce("model.bed_shear", c.model.bed_shear, Model{}.bed_shear);
    if (c.model.implementation == Implementation::law) {
      announce("model.bed_load", c.model.bed_load);
      announce("model.bed_surface", c.model.bed_surface, SurfaceHold::free);
    }
  }
  announce("numerics.viscosity", c.numerics.viscosity, Numerics{}.viscosity);
}

/// Tells what drives the water, and with which numerics.
void announce_flow(const Case& c) {
  if (c.flow.drive == Drive::off) return;
  announce("flow.drive", c.flow.drive);
  spdlog::info("flow along {}: smoothing_ratio {:g}, artificial_viscosity {:g}; history.csv has its velocity and drive",
               c.flow.along, c.numerics.smoothing_ratio, c.numerics.artificial_viscosity);
  if (c.flow.guide_length > 0) {
    spdlog::info("flow: guided towards the logarithmic profile over {} from {} = {}",
                 format_quantity(c.flow.guide_length, "m"), c.flow.along, format_quantity(c.flow.guide_from, "m"));
  }
}

/// Tells where water enters and leaves.
void announce_openings(const Case& c) {
  const auto announce_one = [&](const char* table, const Opening& opening, const std::string& what) {
    spdlog::info("{} {}: {}; history.csv has its columns {}_...", table, opening.name, what, opening.name);
  };
  for (const Inlet& inlet : c.inlets) {
    const double area = inlet.area(c.info.dimension);
    const double rate = inlet.flow_rate_at(0, area, c.info.dimension);
    announce_one("inlet", inlet,
                 fmt::format("{:.4g} {} at the start, profile {}, surface {}{}", rate,
                             c.info.dimension == 2 ? "m^2/s" : "m^3/s", word_for(inlet.profile),
                             word_for(inlet.surface), inlet.absorbs_waves ? ", waves leave through it" : ""));
    if (inlet.bed_load != InletBedLoad::none) {
      announce_one("inlet", inlet, fmt::format("bed load {}", word_for(inlet.bed_load)));
    }
  }
  for (const Outlet& outlet : c.outlets) announce_one("outlet", outlet, word_for(outlet.kind));
}

}  // namespace

void announce_choices(const Case& of) {
  announce("numerics.accuracy", of.numerics.accuracy, Numerics{}.accuracy);
  announce("numerics.precision", of.numerics.precision, Numerics{}.precision);
  announce("model.turbulence", of.model.turbulence, Model{}.turbulence);
  announce("model.wall_friction", of.model.wall_friction, Model{}.wall_friction);
  if (of.model.thin_films)
    spdlog::info("model.thin_films: films of water on walls get thinner where they are stretched");
  announce("numerics.shifting", of.numerics.shifting, Shifting::off);
  announce_flow(of);
  announce_openings(of);
  if (of.has_sediment()) announce_sediment(of);
  announce_seepage(of);
  for (const std::string& warning : warnings_of_coarse_grains(of)) spdlog::warn(warning);
}

std::vector<std::string> warnings_of_coarse_grains(const Case& c) {
  std::vector<std::string> warnings;
  if (c.model.sediment != SedimentModel::three_state || c.model.implementation != Implementation::law) return warnings;
  const double spacing = c.numerics.spacing;
  for (const auto& entry : c.sediments) {
    const std::string& name = entry.first;
    const SedimentTable& grains = entry.second;
    const auto warn = [&](const char* key, double length, const char* effect, const char* cure) {
      warnings.push_back(fmt::format("materials.{}.{} = {} is more than the spacing of {}: {}; {}", name, key,
                                     format_quantity(length, "m"), format_quantity(spacing, "m"), effect, cure));
    };
    if (grains.grain_diameter > spacing) {
      warn("grain_diameter", grains.grain_diameter, "a layer of particles cannot carry all of the law's bed load",
           "choose a spacing above the grain diameter");
    }
    if (grains.roughness > spacing) {
      warn("roughness", grains.roughness, "the water next to the bed lies below the logarithmic profile",
           "choose a spacing above the roughness");
    }
  }
  return warnings;
}

void warn_of_fast_walls(const Case& c, double speed) {
  if (speed <= c.numerics.maximum_speed) return;
  spdlog::warn("walls move with up to {:.3g} m/s, and numerics.maximum_speed is {:.3g} m/s: {}", speed,
               c.numerics.maximum_speed, "the water's density will vary by more than a percent; raise it");
}

}  // namespace thalweg
