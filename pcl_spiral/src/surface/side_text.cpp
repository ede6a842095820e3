// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/surface/impl/side_text.h>

#include "graph/side_limits.h"
#include <pcl_spiral/core/diagnostic.h>

#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double weak_z = 0.4;           // mean cosine: an upright hemisphere has 0.5, a wall 0
constexpr double agreeing_z = 0.75;      // share of the area: a part with larger undercuts has no side towards +z
constexpr double weak_view = 0.1;        // mean cosine: at most a flat scan seen under 6 degrees
constexpr double agreeing_view = 0.9;    // share of the area: a scanner sees only what faces it, but for noise
constexpr double surrounding_view = 0.7; // an arc of three quarters of a turn about its centre has 1 - sin(135 deg) / 2.36 = 0.7
constexpr double clearly_curved = 0.1;   // mean cosine with the direction from the centroid

constexpr const char* remedy = ": give a view point on the side of the cutter ({setViewPoint}), or flip the normals "
                               "({setFlipNormals}) if the cutter comes from the other side";

Diagnostic
percent(double share)
{
  return Diagnostic(std::round(1000.0 * share) / 10.0, " %");
}

double
rounded(double cosine)
{
  return std::round(1000.0 * cosine) / 1000.0;
}

const char*
curvedSide(const OuterSide& side)
{
  const double cosine = side.flipped ? -side.convex_cosine : side.convex_cosine;
  return cosine < -clearly_curved ? ", the hollow side" : cosine > clearly_curved ? ", the convex side" : "";
}

Diagnostic
zWarning(const OuterSide& side)
{
  return Diagnostic("the outer side was taken from +z, but this is not clear: the mean cosine between the normals and +z is ",
                    rounded(side.mean_cosine), " (a hemisphere has 0.5, a wall 0; below ", weak_z, " it is mostly wall), and ",
                    percent(1.0 - side.agreement), " of the area faces down; the path is on this side", curvedSide(side), remedy);
}

Diagnostic
viewWarning(const OuterSide& side)
{
  if (side.view_spread > surrounding_view)
    return Diagnostic("the surface surrounds the view point by more than three quarters of a turn, so the inner side was taken", remedy);
  if (side.agreement < agreeing_view)
    return Diagnostic(percent(1.0 - side.agreement), " of the area faces away from the view point, but a scanner sees only what faces it (",
                      percent(1.0 - agreeing_view),
                      " is the limit): the place is wrong, or the {scan} is made of several views; "
                      "the path is on the side that most of the area shows to it",
                      curvedSide(side), remedy);
  return Diagnostic("the view point sees the surface almost along it: the mean cosine is ", rounded(side.mean_cosine), ", below ",
                    weak_view, remedy);
}

Diagnostic
normalsWarning(const OuterSide& side)
{
  return Diagnostic("the given normals face away from +z (mean cosine ", rounded(side.z_cosine), "), and the path is on this side",
                    curvedSide(side),
                    ": flip the normals ({setFlipNormals}) if the cutter comes from +z; else confirm the side with a view "
                    "point on it ({setViewPoint})");
}

bool
isClear(const OuterSide& side)
{
  switch (side.vote) {
  case SideVote::PlusZ:
    return side.mean_cosine >= weak_z && side.agreement >= agreeing_z;
  case SideVote::ViewPoint:
    return side.mean_cosine >= weak_view && side.agreement >= agreeing_view && side.view_spread <= surrounding_view;
  case SideVote::GivenNormals:
    return side.z_cosine > -clear_z || side.convex_cosine > -clearly_curved || side.view_cosine > 0.0;
  case SideVote::ToolAxis:
    return true;
  case SideVote::Convex:
    break;
  }
  return false;
}

} // namespace

const char*
nameOf(SideVote vote)
{
  switch (vote) {
  case SideVote::GivenNormals:
    return "given normals";
  case SideVote::ViewPoint:
    return "view point";
  case SideVote::PlusZ:
    return "+z";
  case SideVote::ToolAxis:
    return "tool axis";
  case SideVote::Convex:
    break;
  }
  return "convex";
}

Diagnostic
sideText(const OuterSide& side)
{
  const Diagnostic agrees(percent(side.agreement), " of the area agrees");
  Diagnostic text;
  if (side.vote == SideVote::GivenNormals)
    text = Diagnostic("by the given normals: ", agrees);
  else if (side.vote == SideVote::ToolAxis)
    return "from where the tool comes, along its axis";
  else if (side.vote == SideVote::Convex)
    text = Diagnostic("the convex side, as +z does not decide (mean cosine ", rounded(std::abs(side.z_cosine)), ")");
  else
    text = Diagnostic("by ", side.vote == SideVote::PlusZ ? "+z" : "the view point", ": mean cosine ", rounded(side.mean_cosine), ", ",
                      agrees);
  if (side.flipped)
    text += "; turned to the other side on request";
  return side.vote == SideVote::Convex && !side.flipped ? text : text + curvedSide(side);
}

Diagnostics
sideWarnings(const OuterSide& side)
{
  Diagnostics warnings;
  if (side.normals_ignored && side.vote != SideVote::ViewPoint) // which decides in their place
    warnings.push_back(Diagnostic("the given normals have no common side and were not used: they agree on ",
                                  percent(side.normals_agreement),
                                  " of the area, below 90 %; orient them, or give a view point ({setViewPoint})"));
  if (side.flipped || isClear(side))
    return warnings;
  if (side.vote == SideVote::PlusZ)
    warnings.push_back(zWarning(side));
  else if (side.vote == SideVote::ViewPoint)
    warnings.push_back(viewWarning(side));
  else if (side.vote == SideVote::GivenNormals)
    warnings.push_back(normalsWarning(side));
  else
    warnings.push_back("+z does not show the outer side, so the convex side was taken: give a view point "
                       "({setViewPoint}) or flip the normals ({setFlipNormals}) if the cutter comes from the other side");
  return warnings;
}

Diagnostics
sensorWarnings(const OuterSide& side)
{
  if (side.flipped || side.vote != SideVote::ViewPoint || side.z_cosine > -clear_z)
    return {};
  return {Diagnostic(
      "the path is on the side of the sensor that the {cloud} names (sensor_origin_), which faces away from +z (mean cosine ",
      rounded(side.z_cosine), ")", curvedSide(side),
      "; if the {cloud} was moved or scaled after the {scan}, its sensor may not have been: give the view point ({setViewPoint}), or "
      "flip the normals ({setFlipNormals}) if the cutter comes from +z")};
}

} // namespace pcl_spiral
