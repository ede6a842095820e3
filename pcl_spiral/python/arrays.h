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

/** x y z of an array where they stand; \p arrays keeps them alive. */
struct ArrayColumns {
  PointColumns columns;
  std::vector<py::array> arrays;
};

/** The columns of \p object, which is (N, 3) or has the three \p fields. Only other types than float32 and float64 in the order of this
 *  machine are copied. */
ArrayColumns columnsOf(const std::string& name, const py::object& object, const std::vector<std::string>& fields = {"x", "y", "z"});

/** A scan or a mesh of the user, in mm. */
struct GivenScan : Scan {
  std::string name;                                ///< its file; empty: an array
  pcl::PolygonMesh::ConstPtr mesh;                 ///< null: a scan
  std::optional<Eigen::Vector3d> asked_view_point; ///< of the keyword, in the coordinates of cloud

  /** Sets the input and what decides its side. A given view point goes before normals, and these before the view point of a file. */
  template <typename Stage>
  void setSide(Stage& stage, bool trust_given) const
  {
    if (normals && !asked_view_point)
      stage.setInputNormals(normals);
    if (!trust_given)
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

/** Reads \p points: a file, or an array with faces= and the keyword \p normals. */
GivenScan scanOf(const py::object& points, const Keywords& keywords, const GivenUnits& units, const Words& words,
                 const std::string& normals = "normals");

/** Points of an array or a file, in their order. */
Polyline lineOf(const std::string& name, const py::object& points, const ReadOptions& read, const Words& words);

/** A polygon of an array (N, 2) or (N, 3), or of a file. */
Prism polygonOf(const std::string& name, const py::object& corners, const ReadOptions& read, const Words& words);

/** The file that \p object names; nothing if it is no str or os.PathLike. */
std::optional<std::string> fileOf(const py::handle& object);

/** Parts of (radius, length) or (lower radius, upper radius, length), upwards. */
std::vector<ToolSegment> holderOf(const py::object& given);

} // namespace pcl_spiral::python
