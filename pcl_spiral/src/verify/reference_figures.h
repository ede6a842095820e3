// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What the figures of a judgement say about the reference. Private.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/verify/impl/reference_surface.h>

#include <utility>

namespace pcl_spiral {

/** Sets points, noise, crease band and warnings of the reference; with what is asked for, for noiseWarnings. */
template <typename Figures>
void
describeReference(const ReferenceSurface& reference, double scallop_height, double chord_error, Figures& figures)
{
  figures.reference_points = reference.graph().size();
  figures.noise = reference.noise();
  figures.fit_noise = reference.fitNoise();
  figures.crease_band = reference.creaseBand();
  figures.warnings = reference.warnings();
  for (Diagnostic& warning : noiseWarnings(reference, scallop_height, chord_error))
    figures.warnings.push_back(std::move(warning));
}

} // namespace pcl_spiral
