// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The least length of a spiral over a surface of revolution. mm.
 */
#pragma once

#include "support/surfaces.h"

namespace pcl_spiral::test {

/** Integral of dA / exact step-over of a ball of \p radius that leaves \p scallop, where turns are circles of latitude
 *  about the z axis: the step runs along the meridian. */
double lengthOverLatitudes(const AnalyticSurface& surface, double radius, double scallop);

} // namespace pcl_spiral::test
