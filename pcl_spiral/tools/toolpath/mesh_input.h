// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Input of the spiral from a mesh: samples of its curved surface.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include "outputs.h"
#include "terminal/terminal.h"

/** Reads the mesh of \p job and samples it: sets the scan, its normals and the mesh of \p result, with warnings.
 *  \throw pcl_spiral::FileError, UsageError, Cancelled */
void readMeshSamples(const Job& job, ProgressBar& bar, Result& result);

/** Removes the parts of the mesh without a point in \p surface, which is made of its samples: they are not judged. */
void keepUsedParts(const pcl_spiral::Surface& surface, Result& result);

/** Least width of a hole that the path runs round, mm: as asked for, otherwise one step-over, or six spacings of the samples if
 *  that is more, because the samples do not show narrower holes. */
double meshHoleSize(const Job& job, const SampledMesh& mesh);

/** The warning about creases for a path that follows \p surface; empty without creases. */
pcl_spiral::Diagnostics creaseWarnings(const SampledMesh& mesh, const pcl_spiral::Surface& surface);

/** A failure over samples of \p mesh, with the spacing of the samples and of the vertices. */
pcl_spiral::Status withSpacings(const pcl_spiral::Status& status, const SampledMesh& mesh);
