#include "foam_reference/library/mesh_columns.H"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Pstream.H>
#include <Vector2D.H>
#include <ops.H>
#include <volFields.H>

namespace thalweg::foam {

namespace {

template <class Combine>
void combine_over_ranks(std::vector<double>& values, const Combine& combine) {
  if (!Foam::Pstream::parRun()) return;
  Foam::List<Foam::scalar> list(static_cast<Foam::label>(values.size()));
  std::copy(values.begin(), values.end(), list.begin());
  Foam::Pstream::listCombineGather(list, combine);
  Foam::Pstream::listCombineScatter(list);
  std::copy(list.begin(), list.end(), values.begin());
}

// Number of the interval, of `count` equal ones, in which the value lies. A value just outside counts to the last one.
int interval(double value, double from, double size, int count) {
  return std::clamp(static_cast<int>(std::floor((value - from) / size)), 0, count - 1);
}

}  // namespace

void sum_over_ranks(std::vector<double>& values) { combine_over_ranks(values, Foam::plusEqOp<Foam::scalar>()); }
void least_over_ranks(std::vector<double>& values) { combine_over_ranks(values, Foam::minEqOp<Foam::scalar>()); }
void largest_over_ranks(std::vector<double>& values) { combine_over_ranks(values, Foam::maxEqOp<Foam::scalar>()); }

MeshColumns::MeshColumns(const Foam::fvMesh& mesh, const Foam::dictionary& dict) : mesh_(mesh) {
  const auto origin = dict.get<Foam::Vector2D<Foam::scalar>>("origin");
  const auto size = dict.get<Foam::Vector2D<Foam::scalar>>("size");
  const auto count = dict.get<Foam::Vector2D<Foam::label>>("count");
  const auto periodic = dict.get<Foam::Vector2D<Foam::label>>("periodic");
  grid_ = {count.x(), count.y(), size.x(), size.y(), periodic.x() != 0, periodic.y() != 0};
  origin_[0] = origin.x();
  origin_[1] = origin.y();

  const auto columns = static_cast<std::size_t>(grid_.columns());
  constexpr double far = std::numeric_limits<double>::max();
  std::vector<double> top(columns, -far);
  floor_.assign(columns, far);
  area_.assign(columns, 0.0);
  for (Foam::label cell = 0; cell < mesh.nCells(); ++cell) {
    const Foam::point& centre = mesh.C()[cell];
    const int column = interval(centre.x(), origin_[0], grid_.dx, grid_.nx) +
                       grid_.nx * interval(centre.y(), origin_[1], grid_.dy, grid_.ny);
    double low = far;
    double high = -far;
    for (const Foam::label point : mesh.cellPoints()[cell]) {
      low = std::min(low, mesh.points()[point].z());
      high = std::max(high, mesh.points()[point].z());
    }
    column_.push_back(column);
    height_.push_back(high - low);
    const auto c = static_cast<std::size_t>(column);
    floor_[c] = std::min(floor_[c], low);
    top[c] = std::max(top[c], high);
    area_[c] += mesh.V()[cell];
  }
  least_over_ranks(floor_);
  largest_over_ranks(top);
  sum_over_ranks(area_);
  for (std::size_t c = 0; c < columns; ++c) {
    if (area_[c] > 0) {
      area_[c] /= top[c] - floor_[c];
    } else {
      floor_[c] = 0;
    }
  }
}

std::vector<double> MeshColumns::volume_of(const Foam::scalarField& shares) const {
  std::vector<double> sum(area_.size(), 0.0);
  for (Foam::label cell = 0; cell < mesh_.nCells(); ++cell) {
    sum[static_cast<std::size_t>(of(cell))] += shares[cell] * mesh_.V()[cell];
  }
  sum_over_ranks(sum);
  return sum;
}

double MeshColumns::centre(int column, int axis) const {
  const int index = axis == 0 ? column % grid_.nx : column / grid_.nx;
  return origin_[axis] + (index + 0.5) * grid_.spacing(axis);
}

}  // namespace thalweg::foam
