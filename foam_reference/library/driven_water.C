#include "foam_reference/library/driven_water.H"

#include <addToRunTimeSelectionTable.H>
#include <fvMatrices.H>

namespace Foam {
namespace fv {

defineTypeNameAndDebug(drivenWater, 0);
addToRunTimeSelectionTable(option, drivenWater, dictionary);

drivenWater::drivenWater(const word& name, const word& type, const dictionary& dict, const fvMesh& mesh)
    : option(name, type, dict, mesh) {
  fieldNames_.resize(1, "U");
  applied_.resize(1, false);
  read(dict);
}

// Water in the pores of an eroding bed does not flow and does not count.
drivenWater::Water drivenWater::measure(const volScalarField& alpha, const volVectorField& U) const {
  const auto* bed = mesh_.findObject<volScalarField>("bed");
  scalar volume = 0;
  scalar flow = 0;
  forAll(alpha, cell) {
    const scalar held = alpha[cell] * mesh_.V()[cell] * (bed != nullptr ? 1 - (*bed)[cell] : 1);
    volume += held;
    flow += held * U[cell][axis_];
  }
  reduce(volume, sumOp<scalar>());
  reduce(flow, sumOp<scalar>());
  return {volume, volume > 0 ? flow / volume : 0};
}

// The solver asks once in a step, or once in each of its outer correctors; the first time counts.
double drivenWater::acceleration(const volScalarField& alpha, const volVectorField& U) {
  if (step_ == mesh_.time().timeIndex()) return control_.acceleration;
  const Water water = measure(alpha, U);
  adapt(water);
  step_ = mesh_.time().timeIndex();
  record(water);
  return control_.acceleration;
}

void drivenWater::adapt(const Water& water) {
  if (!is_controlled_) return;
  if (discharge_ > 0 && water.volume > 0) control_.target = discharge_ * area_ / water.volume;
  if (step_ < 0) {
    control_.velocity = water.velocity;
    control_ = thalweg::started(control_);
  } else {
    control_ = thalweg::after_step(control_, water.velocity, mesh_.time().deltaT0Value());
  }
}

void drivenWater::record(const Water& water) {
  if (!Pstream::master()) return;
  if (table_ == nullptr) {
    const fileName folder = mesh_.time().globalPath() / "postProcessing" / name() / "0";
    mkDir(folder);
    table_ = std::make_unique<OFstream>(folder / "drive.dat");
    table_->precision(12);
    *table_ << "# time [s]  mean velocity [m/s] of the water at the step's begin  acceleration [m/s^2]  volume [m^3]"
            << endl;
  }
  *table_ << mesh_.time().timeOutputValue() << tab << water.velocity << tab << control_.acceleration << tab
          << water.volume << endl;
}

void drivenWater::addSup(const volScalarField&, fvMatrix<vector>& momentum, const label) {
  const auto& alpha = mesh_.lookupObject<volScalarField>(IOobject::groupName("alpha", water_));
  vector along(Zero);
  along[axis_] = water_density_ * acceleration(alpha, momentum.psi());
  momentum += alpha * dimensionedVector("drive", dimDensity * dimAcceleration, along);
}

bool drivenWater::read(const dictionary& dict) {
  if (!option::read(dict)) return false;
  water_ = coeffs_.get<word>("waterPhase");
  axis_ = coeffs_.get<label>("axis") == 1 ? vector::Y : vector::X;
  const dictionary& phase = mesh_.lookupObject<IOdictionary>("transportProperties").subDict(water_);
  water_density_ = dimensionedScalar("rho", dimDensity, phase).value();
  is_controlled_ = !coeffs_.readIfPresent("acceleration", control_.acceleration);
  if (!is_controlled_) return true;
  discharge_ = coeffs_.getOrDefault<scalar>("discharge", 0);
  if (discharge_ > 0) {
    area_ = coeffs_.get<scalar>("area");
  } else {
    control_.target = coeffs_.get<scalar>("velocity");
  }
  control_.time = coeffs_.get<scalar>("time");
  if (step_ < 0) control_.drag = coeffs_.get<scalar>("drag");
  return true;
}

}  // namespace fv
}  // namespace Foam
