#include "foam_reference/library/effective_pressure_field.H"

#include <algorithm>
#include <cmath>

#include <IStringStream.H>
#include <fvm.H>
#include <wallFvPatch.H>
#include <zeroGradientFvPatchFields.H>

namespace thalweg::foam {

namespace {

using Foam::label;

Foam::scalarField weight_of_columns(const EffectivePressureLaw& law, const MeshColumns& columns,
                                    const Foam::volScalarField& sediment) {
  GrainColumns bed;
  bed.grid = columns.grid();
  bed.area = columns.area();
  bed.floor = columns.floor();
  bed.grains = columns.volume_of(sediment.primitiveField());
  std::vector<double> cos2(bed.area.size());
  for (std::size_t c = 0; c < cos2.size(); ++c) {
    const int column = static_cast<int>(c);
    const double steepest = std::hypot(bed.slope(column, 0), bed.slope(column, 1));
    const double tangent = std::min(steepest, law.friction_tangent);
    cos2[c] = 1 / (1 + tangent * tangent);
  }
  const Foam::fvMesh& mesh = sediment.mesh();
  Foam::scalarField pressure(mesh.nCells());
  for (label cell = 0; cell < mesh.nCells(); ++cell) {
    const int column = columns.of(cell);
    const double above = std::max(0.0, bed.level(column) - mesh.C()[cell].z());
    pressure[cell] = effective_pressure_of_column(law.submerged_weight, above, cos2[static_cast<std::size_t>(column)]);
  }
  return pressure;
}

Foam::scalarField laplace(const EffectivePressureLaw& law, const MeshColumns& columns,
                          const Foam::volScalarField& sediment) {
  const Foam::fvMesh& mesh = sediment.mesh();
  Foam::volScalarField pressure(Foam::IOobject("effectivePressure", mesh.time().timeName(), mesh,
                                               Foam::IOobject::NO_READ, Foam::IOobject::NO_WRITE, false),
                                mesh, Foam::dimensionedScalar(Foam::dimPressure, Foam::Zero),
                                Foam::zeroGradientFvPatchScalarField::typeName);
  pressure.primitiveFieldRef() = weight_of_columns(law, columns, sediment);

  Foam::DynamicList<label> above;
  Foam::DynamicList<Foam::scalar> surface_pressure;
  for (label cell = 0; cell < mesh.nCells(); ++cell) {
    if (sediment[cell] > 0.5) continue;
    above.append(cell);
    // The bed's surface lies half a cell below this centre; the linear profile through it is negative here.
    surface_pressure.append(-law.submerged_weight * columns.cell_height(cell) / 2);
  }
  Foam::fvScalarMatrix equation(Foam::fvm::laplacian(pressure));
  // Weight at walls: dp/dn = -submerged weight * n_z, an inflow the matrix does not know.
  forAll(mesh.boundary(), patch) {
    if (!Foam::isA<Foam::wallFvPatch>(mesh.boundary()[patch])) continue;
    const Foam::labelUList& cells = mesh.boundary()[patch].faceCells();
    forAll(cells, face) {
      equation.source()[cells[face]] += law.submerged_weight * mesh.Sf().boundaryField()[patch][face].z();
    }
  }
  equation.setValues(above, surface_pressure);
  Foam::IStringStream settings("solver PCG; preconditioner DIC; tolerance 1e-10; relTol 1e-6;");
  equation.solve(Foam::dictionary(settings));
  return Foam::max(pressure.primitiveField(), Foam::scalar(0));
}

Foam::scalarField total_pressure(const Foam::fvMesh& mesh) {
  const auto* total = mesh.cfindObject<Foam::volScalarField>("p");
  if (total == nullptr) return Foam::scalarField(mesh.nCells(), 0);
  return Foam::max(total->primitiveField(), Foam::scalar(0));
}

Foam::scalarField share_of_pressure(const EffectivePressureLaw& law, const Foam::fvMesh& mesh) {
  Foam::scalarField pressure = total_pressure(mesh);
  for (auto& p : pressure) p = effective_pressure_of_state(p, law.pore_density, law.bed_density);
  return pressure;
}

}  // namespace

Foam::scalarField effective_pressure(const EffectivePressureLaw& law, const MeshColumns& columns,
                                     const Foam::volScalarField& sediment) {
  switch (law.closure) {
    case EffectivePressure::laplace:
      return laplace(law, columns, sediment);
    case EffectivePressure::eos:
      return share_of_pressure(law, sediment.mesh());
    case EffectivePressure::total:
      return total_pressure(sediment.mesh());
    case EffectivePressure::column:
      break;
  }
  return weight_of_columns(law, columns, sediment);
}

}  // namespace thalweg::foam
