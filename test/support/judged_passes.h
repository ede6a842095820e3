// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Passes of a ball over a dome, judged by a scan of it, as a viewer shows and plays them.
 */
#pragma once

#include "support/even_cloud.h"
#include "support/passes.h"
#include "support/reference.h"

#include <pcl_spiral/planning/impl/path_judge.h>
#include <pcl_spiral/verify/impl/reference_surface.h>
#include <pcl_spiral/visualization/spiral_viewer.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral::test {

/** Lengths in mm. */
struct JudgedPasses {
  double dome_radius = 60.0, part_radius = 12.0, half = 12.0; ///< half: of the square of the passes
  double tool_radius = 6.0, scallop = 0.05, contact_spacing = 0.8;
  std::size_t points = 3000, most_places = 250000;
  VerificationScene scene;
  PlaybackScene played;

  void make()
  {
    const SurfacePtr surface = ball(dome_radius, Region({circle({0, 0}, part_radius)}));
    JudgedInput input;
    input.cloud = toCloud(sampleUniform(*surface, points, 1).points);
    input.settings.cutter = CutterShape::ball(tool_radius);
    input.settings.scallop_height = scallop;
    std::vector<double> us;
    for (double u = -half; u <= half; u += exactStepOver(tool_radius, scallop, 1.0 / dome_radius))
      us.push_back(u);
    GivenPath given;
    const auto path = toolpath(straightPasses(*surface, us, half, contact_spacing));
    for (std::size_t i = 1; i < path->size(); ++i)
      (*path)[i].arc_length = (*path)[i - 1].arc_length + ((*path)[i].getVector3fMap() - (*path)[i - 1].getVector3fMap()).norm();
    given.path = path;
    PathJudge judge;
    JudgedPath judged;
    ASSERT_TRUE(judge.prepare(input, 0.0).ok());
    judge.setProgress({});
    ASSERT_TRUE(judge.judge(given, 0, judged).ok());
    const ReferenceSurface& reference = *judge.parts().front().reference;
    scene.part.title = "dome";
    scene.part.cloud = input.cloud;
    scene.part.path = judged.path;
    scene.part.settings.tool_radius = tool_radius;
    scene.part.settings.scallop_height = scallop;
    scene.part.report.loops = reference.loops();
    scene.part.report.spacing = reference.graph().spacing();
    scene.stock = judged.heights.stock;
    scene.removal_figures = judged.verification.removal;
    played.cutter = input.settings.cutter;
    played.machine = xyzacTrunnion();
    played.left = stockMesh(reference, judged.heights.stock, most_places);
    played.stops.push_back({"look here", 100, {}});
  }
};

} // namespace pcl_spiral::test
