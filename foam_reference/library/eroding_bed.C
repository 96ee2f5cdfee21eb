#include "foam_reference/library/eroding_bed.H"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Tuple2.H>
#include <addToRunTimeSelectionTable.H>
#include <gravityMeshObject.H>
#include <surfaceFields.H>
#include <zeroGradientFvPatchFields.H>
#include "foam_reference/library/dictionary_choices.H"
#include "foam_reference/library/suspended_grains.H"
#include "physics/bed/avalanche.hpp"
#include "physics/bed/move_bed_load.hpp"
#include "physics/water/von_karman.hpp"

namespace Foam {
namespace functionObjects {

defineTypeNameAndDebug(erodingBed, 0);
addToRunTimeSelectionTable(functionObject, erodingBed, dictionary);

namespace {

using thalweg::BedLoad;
using thalweg::PickUp;
using thalweg::SlopeEffect;
using thalweg::foam::dictionary_choices;

constexpr double far = std::numeric_limits<double>::max();

const auto bed_loads = dictionary_choices(BedLoad::meyer_peter_mueller, BedLoad::wong_parker, BedLoad::engelund_fredsoe,
                                          BedLoad::van_rijn);
const auto slope_effects = dictionary_choices(SlopeEffect::friction, SlopeEffect::threshold);
const auto pick_ups = dictionary_choices(PickUp::mastbergen, PickUp::van_rijn);

std::size_t at(int column) { return static_cast<std::size_t>(column); }

// The water above a column: height of the place over the bed, and velocity there. The lower one of two wins.
using Above = Tuple2<scalar, vector>;
struct Lower {
  void operator()(Above& a, const Above& b) const {
    if (b.first() < a.first()) a = b;
  }
};

}  // namespace

erodingBed::erodingBed(const word& name, const Time& time, const dictionary& dict)
    : fvMeshFunctionObject(name, time, dict),
      columns_(mesh_, dict.subDict("columns")),
      bed_share_(field("bed", IOobject::MUST_READ)),
      grains_(field("grains", IOobject::MUST_READ)),
      drag_field_(field("bedDrag", IOobject::NO_READ)),
      k_over_bed_(IOobject("kOverBed", mesh_.time().timeName(), mesh_, IOobject::NO_READ, IOobject::NO_WRITE), mesh_,
                  dimensionedScalar("k", dimVelocity * dimVelocity, -1)),
      omega_over_bed_(IOobject("omegaOverBed", mesh_.time().timeName(), mesh_, IOobject::NO_READ, IOobject::NO_WRITE),
                      mesh_, dimensionedScalar("omega", dimless / dimTime, -1)),
      free_(IOobject("freeOfBed", mesh_.time().timeName(), mesh_, IOobject::NO_READ, IOobject::NO_WRITE), mesh_,
            dimensionedScalar(dimless, Zero), zeroGradientFvPatchScalarField::typeName) {
  read(dict);
  bed_.grid = columns_.grid();
  bed_.packing = 1 - grains_law_.porosity;
  bed_.area = columns_.area();
  bed_.floor = columns_.floor();
  bed_.grains = columns_.volume_of(bed_share_.primitiveField());
  for (double& grains : bed_.grains) grains *= bed_.packing;
  const auto columns = at(bed_.grid.columns());
  bed_.end.assign(columns, thalweg::BedEnd::closed);
  for (const Pair<point>& box : dict.getOrDefault<List<Pair<point>>>("fed", List<Pair<point>>())) {
    for (int column = 0; column < bed_.grid.columns(); ++column) {
      const point place(columns_.centre(column, 0), columns_.centre(column, 1), box.first().z());
      if (boundBox(box.first(), box.second()).contains(place)) bed_.end[at(column)] = thalweg::BedEnd::fed;
    }
  }
  stress_.resize(columns);
  critical_.assign(columns, 0);
  pick_up_.assign(columns, 0);
  brake_.assign(columns, 0);
  lowest_.assign(columns, far);
  update_fields();
  write_balance();
}

volScalarField& erodingBed::field(const word& name, IOobject::readOption read) {
  const IOobject object(name, mesh_.time().timeName(), mesh_, read, IOobject::AUTO_WRITE);
  auto* made = read == IOobject::MUST_READ
                   ? new volScalarField(object, mesh_)
                   : new volScalarField(object, mesh_, dimensionedScalar(dimless / dimTime, Zero));
  return mesh_.objectRegistry::store(made);
}

bool erodingBed::read(const dictionary& dict) {
  fvMeshFunctionObject::read(dict);
  water_ = dict.get<word>("waterPhase");
  const dictionary& water = mesh_.lookupObject<IOdictionary>("transportProperties").subDict(water_);
  drag_ = dict.get<scalar>("drag");
  auto& law = grains_law_;
  law.density = dict.get<scalar>("grainDensity");
  law.porosity = dict.get<scalar>("porosity");
  law.diameter = dict.get<scalar>("grainDiameter");
  law.tan_friction = std::tan(dict.get<scalar>("frictionAngle"));
  law.lift_ratio = dict.get<scalar>("liftRatio");
  law.roughness = dict.get<scalar>("roughness");
  law.critical_shields = dict.get<scalar>("criticalShields");
  law.bed_load = bed_loads.get("bedLoad", dict);
  law.slope_effect = slope_effects.get("slopeEffect", dict);
  law.pick_up = pick_ups.get("pickUp", dict);
  law.water_density = dimensionedScalar("rho", dimDensity, water).value();
  law.water_viscosity = dimensionedScalar("nu", dimViscosity, water).value();
  law.gravity = mag(meshObjects::gravity::New(time_).value());
  return true;
}

std::vector<double> erodingBed::suspended() const { return columns_.volume_of(grains_.primitiveField()); }

// The velocity is taken at least half a cell above the bed, because a cell below that is partly bed.
void erodingBed::find_transport() {
  const auto& U = mesh_.lookupObject<volVectorField>("U");
  const auto& water = mesh_.lookupObject<volScalarField>(IOobject::groupName("alpha", water_));
  List<Above> above(bed_.grid.columns(), Above(far, Zero));
  std::fill(lowest_.begin(), lowest_.end(), far);
  for (label cell = 0; cell < mesh_.nCells(); ++cell) {
    if (free_[cell] < 0.5) continue;
    const int column = columns_.of(cell);
    const double height = mesh_.C()[cell].z() - bed_.level(column);
    lowest_[at(column)] = std::min(lowest_[at(column)], height);
    if (height < 0.499 * columns_.cell_height(cell)) continue;
    Lower()(above[column], Above(height, water[cell] >= 0.5 ? U[cell] : vector(Zero)));
  }
  thalweg::foam::least_over_ranks(lowest_);
  Pstream::listCombineGather(above, Lower());
  Pstream::listCombineScatter(above);

  for (int column = 0; column < bed_.grid.columns(); ++column) {
    const auto c = at(column);
    const double slope_x = bed_.slope(column, 0);
    const double slope_y = bed_.slope(column, 1);
    const vector normal = normalised(vector(-slope_x, -slope_y, 1));
    const vector velocity = above[column].second();
    const double speed = mag(velocity - (velocity & normal) * normal);
    const double over_ground = std::hypot(velocity.x(), velocity.y());
    stress_[c] = {};
    if (over_ground > 0) {
      stress_[c] = thalweg::bed_stress(grains_law_, speed, above[column].first(), velocity.x() / over_ground,
                                       velocity.y() / over_ground);
    }
    critical_[c] = thalweg::critical_on_slope(grains_law_, stress_[c], slope_x, slope_y);
    pick_up_[c] = thalweg::pick_up_of(grains_law_, stress_[c], critical_[c]);
    brake_[c] = speed > 0 ? stress_[c].friction_velocity * stress_[c].friction_velocity / speed : 0;
  }
}

// Grains rise from each column into the lowest free cells above it, and settle from them. A cell takes no more grains
// than it holds when packed.
void erodingBed::exchange_with_water() {
  const double dt = time_.deltaTValue();
  const auto& water = mesh_.lookupObject<volScalarField>(IOobject::groupName("alpha", water_));
  const auto is_lowest = [&](label cell) {
    const int column = columns_.of(cell);
    const double height = mesh_.C()[cell].z() - bed_.level(column);
    return free_[cell] > 0.5 && height < lowest_[at(column)] + 1e-6 * columns_.cell_height(cell);
  };
  std::vector<double> room(bed_.grains.size(), 0.0);  // [m^3] for grains in the lowest free cells
  scalarField settled(mesh_.nCells(), 0);             // [m^3]
  for (label cell = 0; cell < mesh_.nCells(); ++cell) {
    if (!is_lowest(cell)) continue;
    const double held = grains_[cell] * mesh_.V()[cell];
    settled[cell] = held * std::min(1.0, grains_law_.settling(grains_[cell]) * dt / columns_.cell_height(cell));
    if (water[cell] >= 0.5) {
      room[at(columns_.of(cell))] += std::max(0.0, bed_.packing * water[cell] * mesh_.V()[cell] - held);
    }
  }
  thalweg::foam::sum_over_ranks(room);
  std::vector<double> lifted(bed_.grains.size(), 0.0);  // [m^3]
  for (std::size_t c = 0; c < lifted.size(); ++c) {
    lifted[c] = std::min({pick_up_[c] * bed_.area[c] * dt, bed_.grains[c], room[c]});
  }
  std::vector<double> deposit(bed_.grains.size(), 0.0);
  for (label cell = 0; cell < mesh_.nCells(); ++cell) {
    if (!is_lowest(cell)) continue;
    const auto c = at(columns_.of(cell));
    double gained = 0;
    if (water[cell] >= 0.5 && room[c] > 0) {
      const double held = grains_[cell] * mesh_.V()[cell];
      gained = lifted[c] * std::max(0.0, bed_.packing * water[cell] * mesh_.V()[cell] - held) / room[c];
    }
    deposit[c] += settled[cell];
    grains_[cell] += (gained - settled[cell]) / mesh_.V()[cell];
  }
  thalweg::foam::sum_over_ranks(deposit);
  for (std::size_t c = 0; c < deposit.size(); ++c) bed_.grains[c] += deposit[c] - lifted[c];
}

// Suspended grains in cells that the rising surface has covered go to the bed, which raises it a little more.
void erodingBed::take_in_covered_grains() {
  std::vector<double> taken(bed_.grains.size(), 0.0);
  for (label cell = 0; cell < mesh_.nCells(); ++cell) {
    const int column = columns_.of(cell);
    if (grains_[cell] == 0 || mesh_.C()[cell].z() >= bed_.level(column)) continue;
    taken[at(column)] += grains_[cell] * mesh_.V()[cell];
    grains_[cell] = 0;
  }
  thalweg::foam::sum_over_ranks(taken);
  for (std::size_t c = 0; c < taken.size(); ++c) bed_.grains[c] += taken[c];
}

// A layer of constant stress over the bed: k = u*^2/sqrt(C_mu), omega = u*/(sqrt(C_mu) kappa z), C_mu = 0.09. In the bed
// nothing eddies: the eddy viscosity is 1e-11 m^2/s there.
void erodingBed::set_eddies(label cell, bool is_lowest, double z) {
  constexpr double root_of_c_mu = 0.3;
  const double u = stress_[at(columns_.of(cell))].friction_velocity;
  k_over_bed_[cell] = omega_over_bed_[cell] = -1;
  if (free_[cell] < 0.5) {
    k_over_bed_[cell] = 1e-8;
    omega_over_bed_[cell] = 1000;
  } else if (is_lowest && u > 0) {
    k_over_bed_[cell] = u * u / root_of_c_mu;
    omega_over_bed_[cell] = u / (root_of_c_mu * thalweg::von_karman<double> * z);
  }
}

void erodingBed::update_fields() {
  for (label cell = 0; cell < mesh_.nCells(); ++cell) {
    const int column = columns_.of(cell);
    const double height = columns_.cell_height(cell);
    const double above = mesh_.C()[cell].z() - bed_.level(column);
    const double share = std::clamp(0.5 - above / height, 0.0, 1.0);
    bed_share_[cell] = share;
    free_[cell] = above >= 0 ? 1 : 0;
    const bool lowest = above >= 0 && above < lowest_[at(column)] + 1e-6 * height;
    set_eddies(cell, lowest, std::max(above, 0.25 * height));
    // The drag grows from 0 where the surface passes the centre to its full value where the cell is full.
    drag_field_[cell] = drag_ * std::max(0.0, 2 * share - 1) + (lowest ? brake_[at(column)] / height : 0.0);
  }
  bed_share_.correctBoundaryConditions();
  free_.correctBoundaryConditions();
  grains_.correctBoundaryConditions();
  drag_field_.correctBoundaryConditions();
}

bool erodingBed::execute() {
  find_transport();
  const auto& water = mesh_.lookupObject<volScalarField>(IOobject::groupName("alpha", water_));
  const auto& water_flux = mesh_.lookupObject<surfaceScalarField>(IOobject::groupName("alphaPhi0", water_));
  exchange_with_water();
  grains_.correctBoundaryConditions();
  left_ += returnReduce(thalweg::foam::carry_grains(grains_, water, free_, water_flux, grains_law_), sumOp<scalar>());
  thalweg::move_bed_load(
      bed_,
      [&](int column, int axis, bool forward) {
        return thalweg::bed_load_between(bed_, grains_law_, stress_[at(column)], column, axis, forward);
      },
      time_.deltaTValue());
  thalweg::avalanche(bed_, grains_law_.tan_friction);
  take_in_covered_grains();
  update_fields();
  write_balance();
  return true;
}

void erodingBed::write_balance() {
  double suspended_volume = 0;
  for (const double volume : suspended()) suspended_volume += volume;
  double low = far;
  double high = -far;
  for (int column = 0; column < bed_.grid.columns(); ++column) {
    if (bed_.area[at(column)] <= 0) continue;
    low = std::min(low, bed_.level(column));
    high = std::max(high, bed_.level(column));
  }
  if (!Pstream::master()) return;
  if (balance_ == nullptr) {
    const fileName folder = time_.globalPath() / "postProcessing" / name() / time_.timeName();
    mkDir(folder);
    balance_ = std::make_unique<OFstream>(folder / "grains.dat");
    balance_->precision(15);
    *balance_ << "# volumes of grains [m^3], elevations [m]" << nl
              << "# time [s]  bed  suspended  left, less what inlets have fed  lowest  highest" << endl;
  }
  *balance_ << time_.timeOutputValue() << tab << bed_.total() << tab << suspended_volume << tab << left_ - bed_.fed
            << tab << low << tab << high << endl;
}

bool erodingBed::write() {
  const std::vector<double> above = suspended();
  if (!Pstream::master()) return true;
  const fileName folder = time_.globalPath() / "postProcessing" / name() / time_.timeName();
  mkDir(folder);
  OFstream file(folder / "columns.dat");
  file.precision(15);
  file << "# x [m]  y [m]  floor [m]  bed [m]  suspended [m]  friction velocity [m/s]  Shields  critical Shields"
       << "  bed load [m^2/s]  pick-up [m/s]" << nl
       << "# suspended: thickness of the grains in suspension, packed as in the bed" << nl;
  for (int column = 0; column < bed_.grid.columns(); ++column) {
    const auto c = at(column);
    if (bed_.area[c] <= 0) continue;
    file << columns_.centre(column, 0) << tab << columns_.centre(column, 1) << tab << bed_.floor[c] << tab
         << bed_.level(column) << tab << above[c] / (bed_.packing * bed_.area[c]) << tab << stress_[c].friction_velocity
         << tab << stress_[c].shields << tab << critical_[c] << tab
         << thalweg::bed_load_of(grains_law_, stress_[c], critical_[c]) << tab << pick_up_[c] << nl;
  }
  return true;
}

}  // namespace functionObjects
}  // namespace Foam
