// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A .vtp file, with its errors reported.
 */
#pragma once

#include <string>

class vtkPolyData;

namespace pcl_spiral {

/** \throw FileError */
void writePolyData(const std::string& file, vtkPolyData* data);

} // namespace pcl_spiral
