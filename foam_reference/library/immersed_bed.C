#include "foam_reference/library/immersed_bed.H"

#include <addToRunTimeSelectionTable.H>
#include <fvMatrices.H>
#include <fvmSup.H>
#include <gravityMeshObject.H>

namespace Foam {
namespace fv {

defineTypeNameAndDebug(immersedBed, 0);
addToRunTimeSelectionTable(option, immersedBed, dictionary);

immersedBed::immersedBed(const word& name, const word& type, const dictionary& dict, const fvMesh& mesh)
    : option(name, type, dict, mesh) {
  fieldNames_.resize(1, "U");
  applied_.resize(1, false);
  read(dict);
}

void immersedBed::addSup(const volScalarField& rho, fvMatrix<vector>& momentum, const label) {
  const auto& drag = mesh_.lookupObject<volScalarField>("bedDrag");
  const auto& grains = mesh_.lookupObject<volScalarField>("grains");
  const auto& water = mesh_.lookupObject<volScalarField>(IOobject::groupName("alpha", water_));
  const dimensionedScalar excess("excess", dimDensity, excess_density_);
  momentum -= fvm::Sp(rho * drag, momentum.psi());
  // Grains that fall through air do not pull it along.
  momentum += excess * water * grains * meshObjects::gravity::New(mesh_.time());
}

bool immersedBed::read(const dictionary& dict) {
  if (!option::read(dict)) return false;
  excess_density_ = coeffs_.get<scalar>("grainDensity") - coeffs_.get<scalar>("waterDensity");
  water_ = coeffs_.get<word>("waterPhase");
  return true;
}

}  // namespace fv
}  // namespace Foam
