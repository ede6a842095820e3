// SPDX-License-Identifier: BSD-3-Clause
#include "display_surface.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double flatness = 3e-4; ///< of the part's size: a third of a pixel
constexpr int most_pieces = 8;    ///< along an edge
constexpr double most_triangles = 1e6;

/** Number of pieces of each edge of curved faces: the same for all edges, so that pieces of neighbours meet. */
int
piecesOf(const SurfaceMesh& mesh, double size)
{
  double sag = 0.0;
  for (std::size_t t = 0; t < mesh.faceCount(); ++t)
    sag = std::max(sag, mesh.sag(t));
  const double round = std::ceil(std::sqrt(sag / (flatness * size))); // with n pieces the sag is 1 / n^2
  const double room = std::floor(std::sqrt(most_triangles / static_cast<double>(mesh.faceCount())));
  return static_cast<int>(std::clamp(std::min(round, room), 1.0, static_cast<double>(most_pieces)));
}

/** Builds triangles; corners have their own normals, so that creases stay sharp. */
class Pieces {
public:
  explicit Pieces(const Eigen::Vector3d& up) : up_(up)
  {
    normals_->SetNumberOfComponents(3);
    normals_->SetName("Normals");
    heights_->SetName("Height");
  }

  void add(const MeshPatch& patch, int pieces)
  {
    std::vector<vtkIdType> below, row; // points along lines parallel to the edge across from corner 2
    for (int k = pieces; k >= 0; --k) {
      row.clear();
      for (int i = 0; i <= pieces - k; ++i)
        row.push_back(addPoint(patch, Eigen::Vector3d(pieces - k - i, i, k) / pieces));
      for (std::size_t i = 0; i < below.size(); ++i) {
        addTriangle(below[i], row[i], row[i + 1]);
        if (i + 1 < below.size())
          addTriangle(below[i], row[i + 1], below[i + 1]);
      }
      below.swap(row);
    }
  }

  vtkSmartPointer<vtkPolyData> data() const
  {
    auto result = vtkSmartPointer<vtkPolyData>::New();
    result->SetPoints(points_);
    result->SetPolys(triangles_);
    result->GetPointData()->SetNormals(normals_);
    result->GetPointData()->SetScalars(heights_);
    return result;
  }

private:
  vtkIdType addPoint(const MeshPatch& patch, const Eigen::Vector3d& b)
  {
    const Eigen::Vector3d p = patch.position(b), n = patch.normal(b);
    normals_->InsertNextTuple(n.data());
    heights_->InsertNextValue(static_cast<float>(p.dot(up_)));
    return points_->InsertNextPoint(p.data());
  }
  void addTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
  {
    const vtkIdType ids[3] = {a, b, c};
    triangles_->InsertNextCell(3, ids);
  }

  Eigen::Vector3d up_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkFloatArray> normals_, heights_;
  vtkNew<vtkCellArray> triangles_;
};

} // namespace

vtkSmartPointer<vtkPolyData>
meshTriangles(const SurfaceMesh& mesh, double size, const Eigen::Vector3d& up)
{
  const int pieces = piecesOf(mesh, size);
  Pieces result(up);
  for (std::size_t t = 0; t < mesh.faceCount(); ++t)
    result.add(mesh.patch(t), mesh.sag(t) > 0.0 ? pieces : 1);
  return result.data();
}

} // namespace pcl_spiral
