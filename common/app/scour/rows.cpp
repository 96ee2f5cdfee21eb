#include "common/app/scour/rows.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "physics/scour/breusers_time.hpp"
#include "physics/scour/dey_sarkar_wall_jet.hpp"
#include "physics/scour/laursen_clear_water.hpp"
#include "physics/scour/laursen_critical_velocity.hpp"
#include "physics/scour/laursen_live_bed.hpp"
#include "physics/scour/mason_arumugam_plunge_pool.hpp"
#include "physics/scour/pier_time_scale.hpp"
#include "physics/scour/pipeline_time_scale.hpp"
#include "physics/scour/schoklitsch_plunge_pool.hpp"
#include "physics/scour/sheppard_critical_velocity.hpp"
#include "physics/scour/sheppard_melville_pier.hpp"

namespace thalweg {
namespace {

/// Hands inputs to a formula and notes them in its row.
class Take {
 public:
  Take(const Inputs& known, FormulaRow& row) : known_(known), row_(row) {}

  double operator()(const std::string& name) {
    const QuantityKind& kind = quantity_kind(name);
    const auto taken =
        std::find_if(row_.inputs.begin(), row_.inputs.end(), [&](const auto& in) { return in.name == name; });
    if (taken != row_.inputs.end()) return taken->value;
    if (const KnownValue* const known = known_.find(name)) {
      row_.inputs.push_back({name, known->value, kind.unit, known->origin});
      return known->value;
    }
    note_missing(name);
    return std::nan("");
  }
  double relative_density() { return (*this)("grain-density") / (*this)("water-density"); }
  double shields() {
    const double u = (*this)("friction-velocity");
    return u * u / ((relative_density() - 1) * (*this)("gravity") * (*this)("grain"));
  }
  /// The one that is given, or else that of a law, which is noted as an input too.
  double critical_velocity(const char* law, const std::function<double()>& by_law) {
    if (known_.has("critical-velocity")) return (*this)("critical-velocity");
    const double value = by_law();
    if (std::isfinite(value)) row_.inputs.push_back({"critical-velocity", value, "m/s", law});
    return value;
  }
  double sheppard_velocity(double depth) {
    return critical_velocity("Shields' curve and log law", [&] {
      return sheppard_critical_velocity(depth, (*this)("grain"), relative_density(), (*this)("gravity"),
                                        (*this)("viscosity") / (*this)("water-density"));
    });
  }
  double laursen_velocity(double depth) {
    return critical_velocity("Laursen",
                             [&] { return laursen_critical_velocity(depth, (*this)("grain"), relative_density()); });
  }

 private:
  /// Notes what a user would give: for a value that follows from others, those of them that are not known.
  void note_missing(const std::string& name) {
    static const std::map<std::string, std::vector<std::string>> followed{
        {"friction-velocity", {"velocity", "depth", "grain"}},
        {"settling-velocity", {"grain"}},
        {"critical-shields", {"grain"}},
        {"grain-90", {"grain"}},
        {"contracted-depth", {"depth"}},
    };
    std::vector<std::string> roots{name};
    if (const auto found = followed.find(name); found != followed.end()) roots = found->second;
    for (const std::string& root : roots) {
      const bool noted = std::find(row_.missing.begin(), row_.missing.end(), root) != row_.missing.end();
      if (!noted && !known_.has(root)) row_.missing.push_back(root);
    }
    if (row_.missing.empty()) row_.missing.push_back(name);
  }

  const Inputs& known_;
  FormulaRow& row_;
};

/// A value and the limits that it leaves.
struct Outcome {
  double value = 0;
  std::vector<LimitLeft> outside;
};

/// The head of a row: what stands in the table whatever the inputs are.
struct Heading {
  const char* formula;
  const char* gives;
  const char* unit;
  const char* source;
};

FormulaRow row_of(const ScourSubject& subject, const Heading& heading, const std::function<Outcome(Take&)>& formula) {
  FormulaRow row;
  row.subject = subject.title;
  row.formula = heading.formula;
  row.gives = heading.gives;
  row.unit = heading.unit;
  row.source = heading.source;
  Take take(subject.inputs, row);
  Outcome outcome = formula(take);
  if (!row.missing.empty()) return row;
  if (std::isfinite(outcome.value)) row.value = outcome.value;
  row.outside = std::move(outcome.outside);
  return row;
}

std::vector<FormulaRow> pier_rows(const ScourSubject& subject) {
  const auto hec18 =
      row_of(subject,
             {"HEC-18 (CSU)", "scour depth", "m", "FHWA-HIF-12-003 (HEC-18), 5th ed. 2012, eq. 7.1; a design envelope"},
             [&](Take& take) -> Outcome {
               const Hec18Pier pier{.width = take("pier-width"),
                                    .length = take("pier-length"),
                                    .depth = take("depth"),
                                    .velocity = take("velocity"),
                                    .angle = take("pier-angle"),
                                    .gravity = take("gravity"),
                                    .bed_factor = take("bed-factor"),
                                    .nose = subject.nose};
               return {hec18_pier_scour(pier), limits_left(pier)};
             });
  const auto sheppard = row_of(
      subject,
      {"Sheppard & Melville", "scour depth", "m", "Sheppard, Melville & Demir 2014, J. Hydraul. Eng. 140(1), 14-23"},
      [&](Take& take) -> Outcome {
        const double width =
            effective_pier_width(subject.nose, take("pier-width"), take("pier-length"), take("pier-angle"));
        const double depth = take("depth");
        const SheppardMelvillePier pier{.effective_width = width,
                                        .depth = depth,
                                        .velocity = take("velocity"),
                                        .critical_velocity = take.sheppard_velocity(depth),
                                        .grain_diameter = take("grain"),
                                        .gravity = take("gravity")};
        return {sheppard_melville_pier_scour(pier), limits_left(pier)};
      });
  const auto time = row_of(
      subject,
      {"Sumer et al., pier", "time scale", "s", "Sumer, Christiansen & Fredsoe 1992, Proc. 2nd ISOPE 3, 308-315"},
      [&](Take& take) -> Outcome {
        const PierTimeScale pier{.diameter = take("pier-width"),
                                 .depth = take("depth"),
                                 .shields = take.shields(),
                                 .critical_shields = take("critical-shields"),
                                 .grain_diameter = take("grain"),
                                 .relative_density = take.relative_density(),
                                 .gravity = take("gravity")};
        return {pier_time_scale(pier), limits_left(pier)};
      });
  if (subject.nose != PierNose::circular) return {hec18, sheppard};
  return {hec18, sheppard, time};
}

PipelineScour pipe_of(Take& take) {
  return {.diameter = take("pipe-diameter"),
          .gap = take("pipe-gap"),
          .shields = take.shields(),
          .critical_shields = take("critical-shields"),
          .grain_diameter = take("grain"),
          .relative_density = take.relative_density(),
          .gravity = take("gravity")};
}

std::vector<FormulaRow> pipe_rows(const ScourSubject& subject) {
  return {row_of(subject,
                 {"Sumer & Fredsoe, pipe", "scour depth", "m",
                  "Sumer & Fredsoe 2002, The Mechanics of Scour in the Marine Environment; 0.6 D +- 0.2 D"},
                 [](Take& take) -> Outcome {
                   const PipelineScour pipe = pipe_of(take);
                   return {pipeline_scour(pipe), limits_left(pipe)};
                 }),
          row_of(subject,
                 {"Fredsoe et al., pipe", "time scale", "s",
                  "Fredsoe, Sumer & Arnskov 1992, Int. J. Offshore Polar Eng. 2(1)"},
                 [](Take& take) -> Outcome {
                   const PipelineScour pipe = pipe_of(take);
                   return {pipeline_time_scale(pipe), limits_left(pipe)};
                 })};
}

std::vector<FormulaRow> contraction_rows(const ScourSubject& subject) {
  return {row_of(subject, {"Laursen, live bed", "scour depth", "m", "Laursen 1960; HEC-18, 5th ed. 2012, eq. 6.2"},
                 [](Take& take) -> Outcome {
                   const double depth = take("depth");
                   const LaursenLiveBed flow{.depth = depth,
                                             .width = take("width"),
                                             .contracted_width = take("contracted-width"),
                                             .flow_ratio = take("flow-ratio"),
                                             .friction_velocity = take("friction-velocity"),
                                             .settling_velocity = take("settling-velocity"),
                                             .velocity = take("velocity"),
                                             .critical_velocity = take.laursen_velocity(depth)};
                   const double scour = laursen_live_bed_depth(flow) - take("contracted-depth");
                   return {std::max(0.0, scour), limits_left(flow)};
                 }),
          row_of(subject, {"Laursen, clear water", "scour depth", "m", "Laursen 1963; HEC-18, 5th ed. 2012, eq. 6.4"},
                 [](Take& take) -> Outcome {
                   const double depth = take("depth");
                   const double narrowing = take("width") / take("contracted-width") * take("flow-ratio");
                   const LaursenClearWater flow{.discharge = take("discharge") * narrowing,
                                                .grain_diameter = take("grain"),
                                                .relative_density = take.relative_density(),
                                                .velocity = take("velocity"),
                                                .critical_velocity = take.laursen_velocity(depth)};
                   const double scour = laursen_clear_water_depth(flow) - take("contracted-depth");
                   return {std::max(0.0, scour), limits_left(flow)};
                 })};
}

std::vector<FormulaRow> protection_rows(const ScourSubject& subject) {
  const auto flow_of = [](Take& take) {
    const double depth = take("tailwater");
    return BreusersScour{.depth = depth,
                         .velocity = take("discharge") / depth,
                         .critical_velocity = take.sheppard_velocity(depth),
                         .relative_density = take.relative_density(),
                         .turbulence = take("turbulence")};
  };
  const char* const source = "Breusers 1966; Hoffmans & Verheij 1997, Scour Manual; two-dimensional";
  std::vector<FormulaRow> rows{
      row_of(subject, {"Breusers", "time to flow depth", "s", source}, [&](Take& take) -> Outcome {
        const BreusersScour flow = flow_of(take);
        return {breusers_time(flow), limits_left(flow, 0)};
      })};
  if (!subject.inputs.has("time")) return rows;
  rows.push_back(row_of(subject, {"Breusers", "scour depth then", "m", source}, [&](Take& take) -> Outcome {
    const BreusersScour flow = flow_of(take);
    const double time = take("time");
    return {breusers_scour(flow, time), limits_left(flow, time)};
  }));
  return rows;
}

std::vector<FormulaRow> jet_rows(const ScourSubject& subject) {
  std::vector<FormulaRow> rows{
      row_of(subject, {"Dey & Sarkar", "scour depth", "m", "Dey & Sarkar 2006, J. Hydraul. Eng. 132(3), 246-257"},
             [](Take& take) -> Outcome {
               const DeySarkarWallJet jet{.velocity = take("jet-velocity"),
                                          .opening = take("jet-opening"),
                                          .apron = take("apron"),
                                          .tailwater = take("tailwater"),
                                          .grain_diameter = take("grain"),
                                          .relative_density = take.relative_density(),
                                          .gravity = take("gravity")};
               return {dey_sarkar_scour(jet), limits_left(jet)};
             })};
  for (FormulaRow& row : protection_rows(subject)) rows.push_back(std::move(row));
  return rows;
}

std::vector<FormulaRow> fall_rows(const ScourSubject& subject) {
  const auto mason = [](Take& take) {
    return MasonArumugamPlungePool{.discharge = take("discharge"),
                                   .drop = take("drop"),
                                   .tailwater = take("tailwater"),
                                   .grain_diameter = take("grain"),
                                   .gravity = take("gravity")};
  };
  const char* const source = "Mason & Arumugam 1985, J. Hydraul. Eng. 111(2), 220-235";
  return {row_of(subject,
                 {"Schoklitsch", "scour depth", "m", "Schoklitsch 1932, in Whittaker & Schleiss 1984, VAW Mitt. 73"},
                 [](Take& take) -> Outcome {
                   const double depth = schoklitsch_depth(
                       {.discharge = take("discharge"), .drop = take("drop"), .grain_90 = take("grain-90")});
                   return {std::max(0.0, depth - take("tailwater")), {}};
                 }),
          row_of(subject, {"Mason & Arumugam", "scour depth", "m", source},
                 [&](Take& take) -> Outcome {
                   const MasonArumugamPlungePool fall = mason(take);
                   return {std::max(0.0, mason_arumugam_depth(fall) - fall.tailwater), limits_left(fall)};
                 }),
          row_of(subject, {"Mason & Arumugam, models", "scour depth", "m", source}, [&](Take& take) -> Outcome {
            const MasonArumugamPlungePool fall = mason(take);
            return {std::max(0.0, mason_arumugam_model_depth(fall) - fall.tailwater), limits_left_of_models(fall)};
          })};
}

}  // namespace

std::vector<FormulaRow> formula_rows(const ScourSubject& subject) {
  switch (subject.kind) {
    case ScourKind::pier:
      return pier_rows(subject);
    case ScourKind::pipe:
      return pipe_rows(subject);
    case ScourKind::contraction:
      return contraction_rows(subject);
    case ScourKind::wall_jet:
      return jet_rows(subject);
    case ScourKind::plunge_pool:
      return fall_rows(subject);
    case ScourKind::bed_protection:
      return protection_rows(subject);
  }
  return {};
}

}  // namespace thalweg
