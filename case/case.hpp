#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "case/tables/case_info.hpp"
#include "case/tables/compare.hpp"
#include "case/tables/domain.hpp"
#include "case/tables/flow.hpp"
#include "case/tables/foam.hpp"
#include "case/tables/gauge.hpp"
#include "case/tables/gencase.hpp"
#include "case/tables/inlet.hpp"
#include "case/tables/line.hpp"
#include "case/tables/model.hpp"
#include "case/tables/motion.hpp"
#include "case/tables/numerics.hpp"
#include "case/tables/outlet.hpp"
#include "case/tables/output.hpp"
#include "case/tables/sediment.hpp"
#include "case/tables/shape.hpp"
#include "case/tables/surface_bed.hpp"
#include "case/tables/suspended_load.hpp"
#include "case/tables/water.hpp"

namespace thalweg {

/// A whole case, checked: every value in range, every name known, every unit right. Its members are the tables of a
/// case file (case/tables/table.hpp says what a table is), and where they come from.
struct Case {
  std::filesystem::path folder;  // of the case file, for what it refers to
  std::filesystem::path file;
  /// Contents of the files that the case names, as hashes by their names: they tell one mesh from another in hash_of().
  std::map<std::string, std::string> file_hashes;

  CaseInfo info;
  Domain domain;
  std::vector<Shape> shapes;
  std::vector<Motion> motions;
  GencaseParameters gencase;
  WaterParameters water;
  std::map<std::string, SedimentTable> sediments;  // by their names
  Model model;
  SuspendedLoad suspended_load;
  SurfaceBedSettings surface_bed;
  Flow flow;
  std::vector<Inlet> inlets;
  std::vector<Outlet> outlets;
  Numerics numerics;
  Output output;
  std::vector<Gauge> gauges;
  std::vector<ProfileLine> lines;
  Compare compare;
  Foam foam;

  /// The one list of tables, in the order in which they are read, written and described.
  static constexpr auto tables() {
    return std::tuple{&Case::info,           &Case::domain,      &Case::shapes,    &Case::motions,
                      &Case::gencase,        &Case::water,       &Case::sediments, &Case::model,
                      &Case::suspended_load, &Case::surface_bed, &Case::flow,      &Case::inlets,
                      &Case::outlets,        &Case::numerics,    &Case::output,    &Case::gauges,
                      &Case::lines,          &Case::compare,     &Case::foam};
  }

  [[nodiscard]] int dimension() const { return info.dimension; }
  /// Smoothing length of the kernel [m].
  [[nodiscard]] double smoothing_length() const { return numerics.smoothing_ratio * numerics.spacing; }
  /// True if some shape is filled with sediment, or with water that carries grains.
  [[nodiscard]] bool has_sediment() const;
  /// True if some shape is filled with water.
  [[nodiscard]] bool has_water() const;
  /// True if some shape is filled with water that carries grains.
  [[nodiscard]] bool has_concentration() const;
  /// True if a current lasts: driven around a period, or fed by an inlet.
  [[nodiscard]] bool has_lasting_current() const;
  /// True if some wall's shape has a roughness.
  [[nodiscard]] bool has_rough_walls() const;
  /// The one sediment of the scene; throws InputError when there is none or more than one.
  [[nodiscard]] const SedimentParameters& sediment() const;
};

}  // namespace thalweg
