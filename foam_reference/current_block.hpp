#pragma once

#include "foam_reference/mesh_plan.hpp"

namespace thalweg::foam {

/// The block of a scene with a current and no container: it ends at the planes of inlets and outlets and at the ends of
/// periods, and elsewhere where the domain does. Its faces are open but for those of a period, since what the flow
/// reaches there has left the scene; the shapes of walls close it. Upwards and downwards it is cut to what the flow can
/// reach, one layer of wall cells below it, and foam.open_above over the highest fluid and opening. Cells are foam.cell
/// high, and one of their faces lies at the lowest fluid or opening. Throws InputError.
MeshPlan plan_current(const Case& scene);

}  // namespace thalweg::foam
