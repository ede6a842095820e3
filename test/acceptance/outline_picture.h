// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A judged path as a file of points and as a picture from above.
 */
#pragma once

#include "support/path_judge.h"

#include <string>

namespace pcl_spiral::acceptance {

/** Contacts and normals, one line per point: x,y,z,nx,ny,nz. False if the file cannot be written. */
bool writePath(const std::string& file, const test::CheckedPath& path);

/** From above as PNG, \p longest pixels along the longer side: the path thin and grey, samples above 1.05 h
 * red, uncut ones dark red, crossings and jumps with magenta circles, the rims blue, start green, end black. */
bool writePicture(const std::string& file, const test::AnalyticSurface& part, const test::CheckedPath& path,
                  const test::JudgedReport& figures, double h, int longest = 1600);

} // namespace pcl_spiral::acceptance
