// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What a page shows in 3-D: a part, its stock, and the tool that moves over it. Private to io. Lengths in mm, times in s.
 */
#pragma once

#include "scene_part.h"

#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/core/tool_holder.h>
#include <pcl_spiral/machine/machine.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl_spiral {

/** How the tool comes to a place. */
enum class SceneMove : std::uint8_t {
  Cut,  ///< along the path
  Link, ///< over the surface to the next pass
  Air   ///< leads, lifts and rapids
};

/** The tool at the end of a move. */
struct SceneFrame {
  double time = 0.0;                                 ///< since the start
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();     ///< of the cutter
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();   ///< unit, from the tip to the shank
  Eigen::Vector3d contact = Eigen::Vector3d::Zero(); ///< of the cutter with the part; the tip where it is not known
  double length = 0.0;                               ///< cut up to here
  double feed = 0.0;                                 ///< mm/min, see ReportScene::feed_word; 0: a rapid, or not known
  double turn = 0.0;                                 ///< or number of the pass
  RotaryAngles angles;                               ///< of a program, radians
  std::size_t number = 0;                            ///< of the line or block of a program; 0: not known
  SceneMove move = SceneMove::Cut;                   ///< to this place
  float deviation = 0.0f;                            ///< of the contact from the surface; NaN: not measured
};

/** A range of values and its colours. */
struct SceneScale {
  double low = 0.0;  ///< values below have a colour of their own
  double high = 0.0; ///< values above have a colour of their own; not above low: there is nothing to show
};

/** All of a page. */
struct ReportScene {
  ScenePart part;                                     ///< what is cut
  std::vector<SceneFrame> frames;                     ///< in order
  CutterShape cutter;                                 ///< radius 0: a beam
  std::vector<ToolSegment> holder;                    ///< above the cutter; none: a shank as wide as the cutter
  Eigen::Vector3d outward = Eigen::Vector3d::UnitZ(); ///< mean normal of the part: the side to look from
  SceneScale deviation, stock;                        ///< what the colours show
  double uncut = 0.0;                                 ///< height of the stock before the cut
  std::string turn_word = "Turn";                     ///< what SceneFrame::turn counts
  std::string feed_word = "Feed of the contact";      ///< what SceneFrame::feed is where it cuts; elsewhere it is that of the tip
  std::string number_word = "Line";                   ///< what SceneFrame::number is of
  std::string rotary_letters;                         ///< of a program: two, or none
  std::vector<std::string> notes;                     ///< sentences above the scene: what is thinned, what is not shown
};

} // namespace pcl_spiral
