// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Histogram of ridge heights, in a picture or in the viewer.
 */
#pragma once

#include "value_style.h"

namespace pcl_spiral {

/** Whether there are ridges and a limit for them. */
bool hasHistogram(const VerificationScene& scene);

/** The chart of a scene that has one, in a view that fills the page. Returns the lower end of its text,
 * pixels. */
int addHistogram(vtkRenderer* view, const PageSize& page, const VerificationScene& scene);

Title histogramTitle(const VerificationScene& scene);

} // namespace pcl_spiral
