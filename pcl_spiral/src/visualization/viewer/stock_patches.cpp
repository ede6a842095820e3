// SPDX-License-Identifier: BSD-3-Clause
#include "stock_patches.h"

#include "visualization/actors.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace pcl_spiral {
namespace {

constexpr int patches_across = 8; ///< of the diagonal of the part

/** Triangles, or single places where there are none, in the cubes in which their first places are. */
class CubeCells {
public:
  explicit CubeCells(const StockMesh& mesh) : mesh_(mesh), corners_(mesh.triangles.empty() ? 1 : 3)
  {
    const std::vector<std::uint32_t> cubes = cubeOfCells();
    std::vector<std::uint32_t> next = begins_;
    order_.resize(cubes.size());
    for (std::uint32_t cell = 0; cell < cubes.size(); ++cell)
      order_[next[cubes[cell]]++] = cell;
  }

  std::size_t cubes() const { return begins_.size() - 1; }
  int corners() const { return corners_; }
  std::size_t cellsOf(std::size_t cube) const { return begins_[cube + 1] - begins_[cube]; }
  /** Corner \p i of cell \p k of \p cube. */
  std::uint32_t corner(std::size_t cube, std::size_t k, int i) const { return place(order_[begins_[cube] + k], i); }

private:
  std::uint32_t place(std::uint32_t cell, int i) const { return corners_ == 1 ? cell : mesh_.triangles[cell][i]; }

  /** The cube of each cell; begins_ becomes the begin of each cube. */
  std::vector<std::uint32_t> cubeOfCells()
  {
    Eigen::AlignedBox3f box;
    for (const Eigen::Vector3f& p : mesh_.places)
      box.extend(p);
    const float edge = std::max(box.diagonal().norm() / patches_across, 1e-3f);
    std::map<std::array<int, 3>, std::uint32_t> numbers;
    std::vector<std::uint32_t> cubes(corners_ == 1 ? mesh_.places.size() : mesh_.triangles.size());
    begins_.assign(1, 0);
    for (std::uint32_t cell = 0; cell < cubes.size(); ++cell) {
      const Eigen::Array3i at = ((mesh_.places[place(cell, 0)] - box.min()) / edge).array().floor().cast<int>();
      cubes[cell] = numbers.emplace(std::array<int, 3>{at.x(), at.y(), at.z()}, static_cast<std::uint32_t>(numbers.size())).first->second;
      begins_.resize(numbers.size() + 1, 0);
      ++begins_[cubes[cell] + 1];
    }
    std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
    return cubes;
  }

  const StockMesh& mesh_;
  int corners_;
  std::vector<std::uint32_t> begins_, order_; ///< cells of each cube, one cube after the other
};

} // namespace

StockPatches::StockPatches(const StockMesh& mesh, const ValueStyle& style) : normals_(mesh.normals), style_(style)
{
  feet_.reserve(mesh.places.size());
  for (std::size_t i = 0; i < mesh.places.size(); ++i)
    feet_.push_back(mesh.places[i] - mesh.stock[i] * mesh.normals[i]);
  std::vector<std::vector<std::uint32_t>> places;
  std::vector<std::uint32_t> at(mesh.places.size(), Triangulation::none); // of each place in the patch that is made
  const CubeCells cells(mesh);
  for (std::size_t cube = 0; cube < cells.cubes(); ++cube) {
    places.emplace_back();
    vtkNew<vtkCellArray> corners;
    corners->Use32BitStorage();
    for (std::size_t k = 0; k < cells.cellsOf(cube); ++k) {
      corners->InsertNextCell(cells.corners());
      for (int i = 0; i < cells.corners(); ++i) {
        std::uint32_t& own = at[cells.corner(cube, k, i)];
        if (own == Triangulation::none) {
          own = static_cast<std::uint32_t>(places.back().size());
          places.back().push_back(cells.corner(cube, k, i));
        }
        corners->InsertCellPoint(own);
      }
    }
    addPatch(corners, cells.corners() > 1, places.back());
    for (const std::uint32_t place : places.back())
      at[place] = Triangulation::none;
  }
  linkCopies(places);
}

/** A patch over the places \p own. */
void
StockPatches::addPatch(vtkCellArray* cells, bool triangles, const std::vector<std::uint32_t>& own)
{
  Patch patch;
  patch.data = vtkSmartPointer<vtkPolyData>::New();
  patch.places = vtkSmartPointer<vtkFloatArray>::New();
  patch.colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  vtkNew<vtkFloatArray> normals;
  for (vtkFloatArray* const array : {patch.places.Get(), normals.Get()}) {
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(own.size()));
  }
  patch.colors->SetNumberOfComponents(3);
  patch.colors->SetNumberOfTuples(static_cast<vtkIdType>(own.size()));
  for (std::size_t i = 0; i < own.size(); ++i)
    normals->SetTypedTuple(static_cast<vtkIdType>(i), normals_[own[i]].data());
  vtkNew<vtkPoints> points;
  points->SetData(patch.places);
  patch.data->SetPoints(points);
  triangles ? patch.data->SetPolys(cells) : patch.data->SetVerts(cells);
  patch.data->GetPointData()->SetNormals(normals);
  patch.data->GetPointData()->SetScalars(patch.colors);
  patch.actor = surfaceActor(patch.data, surface_color);
  patch.actor->GetMapper()->ScalarVisibilityOn();
  patches_.push_back(patch);
}

void
StockPatches::linkCopies(const std::vector<std::vector<std::uint32_t>>& places)
{
  begins_.assign(feet_.size() + 1, 0);
  for (const auto& own : places)
    for (const std::uint32_t place : own)
      ++begins_[place + 1];
  for (std::size_t i = 1; i < begins_.size(); ++i)
    begins_[i] += begins_[i - 1];
  copies_.resize(begins_.back());
  std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
  for (std::uint32_t patch = 0; patch < places.size(); ++patch)
    for (std::uint32_t point = 0; point < places[patch].size(); ++point)
      copies_[next[places[patch][point]]++] = {patch, point};
}

std::vector<vtkSmartPointer<vtkActor>>
StockPatches::actors() const
{
  std::vector<vtkSmartPointer<vtkActor>> actors;
  for (const Patch& patch : patches_)
    actors.push_back(patch.actor);
  return actors;
}

void
StockPatches::set(std::size_t place, float height)
{
  const Eigen::Vector3f top = feet_[place] + height * normals_[place];
  const Color color = style_.color(height);
  for (std::uint32_t i = begins_[place]; i < begins_[place + 1]; ++i) {
    Patch& patch = patches_[copies_[i].patch];
    const auto point = static_cast<vtkIdType>(copies_[i].point);
    patch.places->SetTypedTuple(point, top.data());
    for (int c = 0; c < 3; ++c)
      patch.colors->SetTypedComponent(point, c, static_cast<unsigned char>(std::lround(255.0 * color[c])));
    patch.changed = true;
  }
}

void
StockPatches::finish()
{
  for (Patch& patch : patches_)
    if (patch.changed) {
      patch.places->Modified();
      patch.colors->Modified();
      patch.data->GetPoints()->Modified();
      patch.data->Modified();
      patch.changed = false;
    }
}

} // namespace pcl_spiral
