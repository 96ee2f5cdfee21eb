#pragma once

#include "case/tables/table.hpp"
#include "physics/sediment/sediment_parameters.hpp"

namespace thalweg {

/// [materials.<sediment>]: the keys are those of its laws.
struct SedimentTable : SedimentParameters {
  static constexpr TableHeading heading{"materials.<sediment>",
                                        "A sediment, under the name by which shapes refer to it."};

  SedimentTable() = default;
  SedimentTable(const SedimentParameters& parameters) : SedimentParameters(parameters) {}

  /// model.implementation = "paper" sets the defaults of consistency and flow index.
  void set_defaults(const GivenWords& given);
  /// model.implementation = "paper" gives the bed the density of its grains, unless the case gives one.
  void complete(const Case& whole);
  void check(const Case& whole, const CheckContext& at) const;
};

}  // namespace thalweg
