// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Arrays and files of the user as scans, meshes and lines.
 */
#pragma once

#include "keywords.h"

#include "core/polygon_prism.h"
#include "io/read/number_column.h"
#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/core/tool_holder.h>
#include <pcl_spiral/io/cloud_reader.h>

#include <pcl/PolygonMesh.h>
#include <pybind11/numpy.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl_spiral::python {

/** x y z of three arrays where they stand. */
PointColumns columnsOf(const py::object& columns);

/** A scan or a mesh of the user, in mm. */
struct GivenScan : Scan {
  GivenScan() { cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>(); }

  std::string name;                                ///< its file; empty: an array
  pcl::PolygonMesh::ConstPtr mesh;                 ///< null: a scan
  std::optional<Eigen::Vector3d> asked_view_point; ///< of the keyword, in the coordinates of cloud
  bool trust_given = true;                         ///< its normals are of an array, or trust_normals= is given

  /** Sets what decides its side. A given view point goes before normals, and these before the view point of a file. */
  template <typename Stage>
  void setSide(Stage& stage) const
  {
    if (normals && !asked_view_point)
      stage.setInputNormals(normals);
    if (!trust_given && !mesh)
      stage.setTrustNormals(false); // normals without a common side are not used, with a warning
    if (asked_view_point || view_point)
      stage.setViewPoint(asked_view_point ? *asked_view_point : *view_point);
  }
};

/** How the user's numbers are read: unit= and origin=. */
struct GivenUnits {
  LengthUnit unit = LengthUnit::Millimetre;
  std::optional<Eigen::Vector3d> origin;

  std::vector<Setting> table();
  ReadOptions options() const;                             ///< of the scan
  ReadOptions options(const Eigen::Vector3d& shift) const; ///< of what belongs to a scan with that \p shift
};

/** The inputs normals= and faces=. */
std::vector<Input> scanInputs();

/** Reads \p points: a file, or columns with faces= and the keyword \p normals. */
GivenScan scanOf(const py::object& points, const Keywords& keywords, const GivenUnits& units, const Words& words,
                 const std::string& normals);

/** Places of rows (N, 2) or (N, 3), or of a file, in their order; none of None. */
Polyline lineOf(const py::object& points, const Words& words);

/** A polygon of rows or of a file. */
Prism polygonOf(const std::string& name, const py::object& corners, const Words& words);

/** Vectors as (N, 3) numbers of their own. */
template <typename Vectors>
py::array
rowsOf(const Vectors& vectors)
{
  using Number = typename Vectors::value_type::Scalar;
  return py::array_t<Number>({static_cast<py::ssize_t>(vectors.size()), py::ssize_t{3}},
                             vectors.empty() ? nullptr : vectors.front().data());
}

/** Numbers as (N) of their own. */
template <typename Number>
py::array
numbersOf(const std::vector<Number>& numbers)
{
  return py::array_t<Number>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

/** Places as (N, 3) rows, mm, in the coordinates before \p shift was subtracted. */
py::array rowsOf(Polyline places, const Eigen::Vector3d& shift);

/** Rows (N, 3) as vectors. */
template <typename Vector>
std::vector<Vector>
vectorsOf(const py::array_t<typename Vector::Scalar>& rows)
{
  std::vector<Vector> vectors(static_cast<std::size_t>(rows.shape(0)));
  for (std::size_t i = 0; i < vectors.size(); ++i)
    vectors[i] = Eigen::Map<const Vector>(rows.data(static_cast<py::ssize_t>(i), 0));
  return vectors;
}

/** Parts of (lower radius, upper radius, length), upwards. */
std::vector<ToolSegment> holderOf(const py::list& parts);

} // namespace pcl_spiral::python
