#pragma once

#include "case/case.hpp"

namespace thalweg {

/// What a table of the case file is, for the reference.
struct TableHeading {
  const char* name;     // as written between the brackets
  const char* meaning;  // one sentence
};

inline constexpr TableHeading shape_heading{
    "[shape]", "Geometry: one such table for every shape, in the order in which they are filled."};
inline constexpr TableHeading motion_heading{"[motion]",
                                             "How moving walls move: one such table for every motion (geometry.md)."};
inline constexpr TableHeading gauge_heading{
    "[gauge]", "What is measured during the run: one such table for every gauge (file-formats.md)."};
inline constexpr TableHeading line_heading{
    "[line]", "3-D: a line in plan along which profiles are taken too: one such table for every line."};
inline constexpr TableHeading water_heading{"materials.water", "The water."};
inline constexpr TableHeading sediment_heading{"materials.<sediment>",
                                               "A sediment, under the name by which shapes refer to it."};

/// Calls visit(heading, table) for every table that occurs once, in reading order. Shapes with their motions, and
/// sediments, of which there may be several, stand where `visit_shapes()` and `visit_sediments()` are called, gauges
/// and lines where `visit_gauges()` is.
template <class Visit, class VisitShapes, class VisitSediments, class VisitGauges>
void for_each_table(Case& of, Visit&& visit, VisitShapes&& visit_shapes, VisitSediments&& visit_sediments,
                    VisitGauges&& visit_gauges) {
  visit(TableHeading{"case", "What the scene is."}, of.info);
  visit(TableHeading{"domain", "Where it takes place."}, of.domain);
  visit_shapes();
  visit(TableHeading{"gencase", "How shapes become particles."}, of.gencase);
  visit(water_heading, of.water);
  visit_sediments();
  visit(TableHeading{"model", "What the scene needs; off unless named."}, of.model);
  visit(TableHeading{"numerics", "How it is computed."}, of.numerics);
  visit(TableHeading{"output", "What is written, and when."}, of.output);
  visit_gauges();
  visit(TableHeading{"compare", "What the result is compared with."}, of.compare);
  visit(TableHeading{"foam", "The mesh model of the same scene."}, of.foam);
}

/// Whether `key` means anything for a shape of this kind and role; a key that does not is an error, not ignored.
bool shape_uses_key(const Shape& shape, std::string_view key, int dimension);

/// The keys without which a shape of this kind is not defined.
std::vector<std::string> shape_needs_keys(const Shape& shape, int dimension);

/// The same of a motion; a rotation by a table has no `start`.
bool motion_uses_key(const Motion& motion, std::string_view key, int dimension);
std::vector<std::string> motion_needs_keys(const Motion& motion, int dimension);

/// Whether a key means anything for a gauge of this kind; it then needs it.
bool gauge_uses_key(const Gauge& gauge, std::string_view key);

}  // namespace thalweg
