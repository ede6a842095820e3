// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The stock over a part in patches: only those that change are drawn anew.
 */
#pragma once

#include "visualization/value_style.h"

#include <pcl_spiral/verify/stock_mesh.h>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Triangles over the stock, raised by its height and in its colour. Points alone where the surface has no triangles. */
class StockPatches {
public:
  /** Heights must be set before they are drawn. */
  StockPatches(const StockMesh& mesh, const ValueStyle& style);

  std::vector<vtkSmartPointer<vtkActor>> actors() const;
  /** Sets the height over \p place; the patches show it after finish. */
  void set(std::size_t place, float height);
  /** Draws the patches anew whose places were set. */
  void finish();

private:
  /** A part of the mesh; a place beside several patches is in each of them. */
  struct Patch {
    vtkSmartPointer<vtkPolyData> data;
    vtkSmartPointer<vtkFloatArray> places;
    vtkSmartPointer<vtkUnsignedCharArray> colors;
    vtkSmartPointer<vtkActor> actor;
    bool changed = false;
  };
  struct Copy {
    std::uint32_t patch, point;
  };
  void addPatch(vtkCellArray* cells, bool triangles, const std::vector<std::uint32_t>& own);
  void linkCopies(const std::vector<std::vector<std::uint32_t>>& places);

  std::vector<Eigen::Vector3f> feet_, normals_;
  ValueStyle style_;
  std::vector<Patch> patches_;
  std::vector<std::uint32_t> begins_; ///< first copy of each place, and the number of all
  std::vector<Copy> copies_;
};

} // namespace pcl_spiral
