// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The holder of a cutter: shank, extensions, chuck, as cones and cylinders on top of each other. Lengths in mm.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include <string>
#include <vector>

namespace pcl_spiral {

/** Part of the tool. */
enum class ToolPart {
  Cutter, ///< up to the top of its flank
  Shank,  ///< above the cutter, as wide as the cutter, if no holder is given or as far as it is not
  Holder  ///< what setHolder gives above the cutter
};

/** Length of the shank above the centre of a ball whose holder is not known, in radii: it is taken as thick as the ball. */
constexpr double shank_radii = 10.0;

/** A conical frustum about the tool axis; a cylinder if both radii are the same. */
struct ToolSegment {
  double lower_radius = 0.0; ///< mm, at the end towards the cutter
  double upper_radius = 0.0; ///< mm, at the end towards the spindle
  double length = 0.0;       ///< mm, along the axis
  std::string name;          ///< for messages: "shank"

  /** Both radii the same; mm. */
  static ToolSegment cylinder(double radius, double length, const std::string& name) { return {radius, radius, length, name}; }
};

/** The fault of the segments, which are listed from the cutter upwards: which one, the value and the remedy; empty if
 * there is none. */
Diagnostic faultOf(const std::vector<ToolSegment>& segments);

/** A stack of segments above a cutter, enlarged by a clearance: to the sides, and downwards where a lower face
 * is wider than what is below it. */
class HolderProfile {
public:
  HolderProfile() = default;
  /** \p base: height above the tip of the lower end of the lowest segment: the top of the flank. \p cutter_radius:
   * radius below it. \throws std::invalid_argument on invalid segments or an invalid clearance. */
  HolderProfile(const std::vector<ToolSegment>& segments, double base, double cutter_radius, double clearance);

  bool empty() const { return parts_.empty(); } ///< Whether there are no segments.
  double radius() const { return radius_; }     ///< the largest radius
  double bottom() const { return bottom_; }     ///< height above the tip
  double top() const { return top_; }           ///< height of its upper end above the tip

  /** The segment that contains a place \p l from the axis and \p height above the tip, or -1, and the depth there:
   * the shortest way out, through the flank or through a lower face that is wider than what is below it. */
  int inside(double l, double height, double& depth) const;

  /** A bound of inside(): no place at \p l or more from the axis and between the heights \p low and \p high above the tip is
   * deeper in a segment than \p depth. Returns the segment, or -1 if no such place lies in one. */
  int mayBeInside(double l, double low, double high, double& depth) const;

private:
  struct Part {
    double bottom, start,
        top;              ///< heights above the tip: of the enlarged lower face, of the lower end, of the upper end
    double radius, slope; ///< enlarged radius at the lower end, and its growth with height
    double cosine;        ///< of the angle between the flank and the axis
    double below;         ///< radius of what is below, not enlarged: the part of a lower face beyond it is free
  };
  std::vector<Part> parts_;
  double radius_ = 0.0, bottom_ = 0.0, top_ = 0.0;
};

} // namespace pcl_spiral
