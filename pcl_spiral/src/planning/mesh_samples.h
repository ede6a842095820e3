// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Input of a plan from a mesh: samples of its curved surface.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/planning/spiral_plan.h>

namespace pcl_spiral {

/** Samples \p mesh, every \p spacing mm or, if that is 0, as its curvature, its creases and \p settings ask for. Sets mesh, samples, and a
 *  warning of \p plan if the faces look down. Fails on a closed mesh, and as MeshSampling. */
Status sampleMesh(const SurfaceMesh::ConstPtr& mesh, double spacing, const SpiralSettings& settings, const ProgressCallback& progress,
                  SpiralPlan& plan);

/** Removes the parts of the mesh without a point in \p surface, which is made of its samples: they are not judged. */
void keepUsedParts(const Surface& surface, SampledMesh& mesh);

/** Least width of a hole that the path runs round, mm: as asked for, otherwise one step-over, or six spacings of the samples if
 *  that is more, because the samples do not show narrower holes. */
double meshHoleSize(const SpiralSettings& settings, const SampledMesh& mesh);

/** The warning about creases for a path that follows \p surface; empty without creases. */
Diagnostics creaseWarnings(const SampledMesh& mesh, const Surface& surface);

/** A failure over samples of \p mesh, with the spacing of the samples and of the vertices. */
Status withSpacings(const Status& status, const SampledMesh& mesh);

} // namespace pcl_spiral
