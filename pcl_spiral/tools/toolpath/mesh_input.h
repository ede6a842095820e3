// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A mesh as the spiral takes it: samples of its curved surface.
 */
#pragma once

#include "outputs.h"
#include "terminal/terminal.h"

/** Read the mesh of \p job and sample it: fills the scan, its normals and the mesh of \p result, with warnings.
 *  \throw pcl_spiral::FileError, UsageError, Cancelled */
void readMeshSamples(const Job& job, ProgressBar& bar, Result& result);

/** Leave the parts out of the mesh that \p surface, made of its samples, has no point of: the judge is not to ask for them. */
void keepUsedParts(const pcl_spiral::Surface& surface, Result& result);

/** Least width of a hole the path runs round, mm: as asked for, else one step-over, or six spacings of the samples where that is
 *  more, as narrower holes do not show in these. */
double meshHoleSize(const Job& job, const MeshInput& mesh);

/** What creases mean for a path that follows \p surface; empty without creases. */
std::vector<std::string> creaseWarnings(const MeshInput& mesh, const pcl_spiral::Surface& surface);

/** A failure to make a path over samples of \p mesh, which tells how far apart these stand and the vertices. */
pcl_spiral::Status withSpacings(const pcl_spiral::Status& status, const MeshInput& mesh);

/** A message about a cloud of samples, as one about the mesh. */
std::string inMesh(std::string message);
