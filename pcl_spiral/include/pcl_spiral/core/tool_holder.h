/** \file
 *  What holds a cutter: shank, extensions, chuck, as cones and cylinders on top of each other. Lengths in mm.
 */
#pragma once

#include <string>
#include <vector>

namespace pcl_spiral {

/** A cone's frustum about the tool axis; a cylinder where both radii are the same. */
struct ToolSegment {
  double lower_radius = 0.0;
  double upper_radius = 0.0;
  double length = 0.0;
  std::string name; ///< for messages: "shank"

  static ToolSegment
  cylinder(double radius, double length, const std::string& name)
  {
    return {radius, radius, length, name};
  }
};

/** What is wrong with segments, from the cutter upwards: which, the value and the remedy; empty where nothing
 * is. */
std::string faultOf(const std::vector<ToolSegment>& segments);

/** A stack of segments above a cutter, grown by a clearance: to the sides, and downwards where a lower face
 * sticks out over what is below it. */
class HolderProfile {
public:
  HolderProfile() = default;
  /** \p base: height of the lowest segment's lower end above the tip: the top of the flank. \p cutter_radius:
   * below it. \throws std::invalid_argument on segments or a clearance that cannot be. */
  HolderProfile(const std::vector<ToolSegment>& segments, double base, double cutter_radius,
                double clearance);

  bool
  empty() const
  {
    return parts_.empty();
  }
  double
  radius() const
  {
    return radius_;
  } ///< the largest
  double
  bottom() const
  {
    return bottom_;
  } ///< above the tip
  double
  top() const
  {
    return top_;
  }

  /** The segment that a place \p l from the axis and \p height above the tip lies in, or -1, and how deep:
   * the shortest way out, through the flank or through a lower face that sticks out. */
  int inside(double l, double height, double& depth) const;

  /** A bound of inside(): no place at \p l or more from the axis and between the heights \p low and \p high above the tip lies
   * deeper in a segment than \p depth. The segment, or -1 where none of them lies in one. */
  int mayBeInside(double l, double low, double high, double& depth) const;

private:
  struct Part {
    double bottom, start,
        top;              ///< heights above the tip: of the grown lower face, of the lower end, of the upper
    double radius, slope; ///< grown, at the lower end, and its growth with height
    double cosine;        ///< of the flank to the axis
    double below;         ///< radius of what is below, not grown: a lower face sticks out beyond it
  };
  std::vector<Part> parts_;
  double radius_ = 0.0, bottom_ = 0.0, top_ = 0.0;
};

} // namespace pcl_spiral
