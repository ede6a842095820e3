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
#include <cmath>
#include <map>

namespace pcl_spiral {
namespace {

constexpr int patches_across = 8; ///< of the diagonal of the part

using Cell = std::vector<std::uint32_t>;

/** The cells of each cube in which their first place is. */
std::vector<std::vector<Cell>>
cellsByCube(const StockMesh& mesh)
{
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& place : mesh.places)
    box.extend(place);
  const float edge = std::max(box.diagonal().norm() / patches_across, 1e-3f);
  std::map<std::array<int, 3>, std::vector<Cell>> cubes;
  const auto add = [&](const Cell& cell) {
    const Eigen::Array3i at = ((mesh.places[cell.front()] - box.min()) / edge).array().floor().cast<int>();
    cubes[{at.x(), at.y(), at.z()}].push_back(cell);
  };
  for (const Triangulation::Triangle& triangle : mesh.triangles)
    add({triangle.begin(), triangle.end()});
  for (std::uint32_t i = 0; mesh.triangles.empty() && i < mesh.places.size(); ++i)
    add({i});
  std::vector<std::vector<Cell>> patches;
  patches.reserve(cubes.size());
  for (auto& [at, cells] : cubes)
    patches.push_back(std::move(cells));
  return patches;
}

} // namespace

StockPatches::StockPatches(const StockMesh& mesh, const ValueStyle& style) : normals_(mesh.normals), style_(style)
{
  for (std::size_t i = 0; i < mesh.places.size(); ++i)
    feet_.push_back(mesh.places[i] - mesh.stock[i] * mesh.normals[i]);
  std::vector<std::vector<std::uint32_t>> places;
  std::vector<std::uint32_t> at(mesh.places.size(), Triangulation::none); // of each place in the patch that is made
  for (const std::vector<Cell>& cells : cellsByCube(mesh)) {
    places.emplace_back();
    addPatch(cells, places.back(), at);
    for (const std::uint32_t place : places.back())
      at[place] = Triangulation::none;
  }
  linkCopies(places);
  for (std::size_t i = 0; i < mesh.places.size(); ++i)
    set(i, mesh.stock[i]);
  finish();
}

void
StockPatches::addPatch(const std::vector<Cell>& cells, std::vector<std::uint32_t>& own, std::vector<std::uint32_t>& at)
{
  vtkNew<vtkCellArray> corners;
  std::vector<vtkIdType> ids;
  for (const Cell& cell : cells) {
    ids.clear();
    for (const std::uint32_t place : cell) {
      if (at[place] == Triangulation::none) {
        at[place] = static_cast<std::uint32_t>(own.size());
        own.push_back(place);
      }
      ids.push_back(at[place]);
    }
    corners->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
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
  cells.front().size() > 1 ? patch.data->SetPolys(corners) : patch.data->SetVerts(corners);
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
