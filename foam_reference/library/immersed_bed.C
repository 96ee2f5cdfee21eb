#include "foam_reference/library/immersed_bed.H"

#include <addToRunTimeSelectionTable.H>
#include <fvMatrices.H>
#include <fvmLaplacian.H>
#include <fvmSup.H>
#include <gravityMeshObject.H>
#include <surfaceFields.H>
#include <surfaceInterpolate.H>

namespace Foam {
namespace fv {

defineTypeNameAndDebug(immersedBed, 0);
addToRunTimeSelectionTable(option, immersedBed, dictionary);

immersedBed::immersedBed(const word& name, const word& type, const dictionary& dict, const fvMesh& mesh)
    : option(name, type, dict, mesh) {
  read(dict);
  fieldNames_ = eddies_ ? wordList{"U", "k", "omega"} : wordList{"U"};
  applied_.resize(fieldNames_.size(), false);
}

void immersedBed::addSup(const volScalarField& rho, fvMatrix<vector>& momentum, const label) {
  const auto& drag = mesh_.lookupObject<volScalarField>("bedDrag");
  const auto& grains = mesh_.lookupObject<volScalarField>("grains");
  const auto& water = mesh_.lookupObject<volScalarField>(IOobject::groupName("alpha", water_));
  const dimensionedScalar excess("excess", dimDensity, excess_density_);
  momentum -= fvm::Sp(rho * drag, momentum.psi());
  // Grains that fall through air do not pull it along.
  momentum += excess * water * grains * meshObjects::gravity::New(mesh_.time());
  if (!eddies_) return;
  // 1 at faces between a free cell and one of the bed. What the solver diffuses through them is taken back.
  const surfaceScalarField free(fvc::interpolate(mesh_.lookupObject<volScalarField>("freeOfBed")));
  const surfaceScalarField at_bed(pos(free - scalar(0.01)) * pos(scalar(0.99) - free));
  const volScalarField eddies(rho * mesh_.lookupObject<volScalarField>("nut"));
  momentum -= fvm::laplacian(at_bed * fvc::interpolate(eddies), momentum.psi());
}

void immersedBed::constrain(fvMatrix<scalar>& equation, const label field) {
  const auto& over_bed = mesh_.lookupObject<volScalarField>(fieldNames_[field] + "OverBed");
  DynamicList<label> cells;
  DynamicList<scalar> values;
  forAll(over_bed, cell) {
    if (over_bed[cell] < 0) continue;
    cells.append(cell);
    values.append(over_bed[cell]);
  }
  equation.setValues(cells, values);
}

bool immersedBed::read(const dictionary& dict) {
  if (!option::read(dict)) return false;
  excess_density_ = coeffs_.get<scalar>("grainDensity") - coeffs_.get<scalar>("waterDensity");
  water_ = coeffs_.get<word>("waterPhase");
  eddies_ = coeffs_.getOrDefault("eddies", false);
  return true;
}

}  // namespace fv
}  // namespace Foam
