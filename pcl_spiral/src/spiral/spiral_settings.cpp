// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/spiral_settings.h>

#include "choice_words.h"
#include "surface/choice_words.h"

#include <cmath>
#include <limits>

namespace pcl_spiral {

std::vector<Setting>
cutterTable(SpiralSettings& s)
{
  const NumberRange angle = NumberRange::above(-90.0).below(90.0);
  return {
      Setting("tool_radius", "setToolRadius", "tool radius", "radius of the ball cutter", "10", s.tool_radius)
          .in("mm", NumberRange::above(0.0)),
      Setting("scallop", "setScallopHeight", "scallop height", "scallop height, the largest ridge between turns", "0.05", s.scallop_height)
          .in("mm", NumberRange::above(0.0)),
      Setting("chord_error", "setChordError", "chord error", "largest distance of linear moves from the curve", "0.002", s.chord_error)
          .in("mm", NumberRange::above(0.0)),
      Setting("max_step", "setMaxStep", "longest step", "longest linear move", "5", s.max_step)
          .in("mm", NumberRange::from(0.0))
          .zeroFor("the tool radius"),
      Setting("tilt", "setTiltAngle", "tilt angle", "side tilt of the axis about the feed direction", "0", s.tilt_angle)
          .in("degrees", angle),
      Setting("lead", "setLeadAngle", "lead angle", "lead of the axis along the feed direction", "5", s.lead_angle).in("degrees", angle),
      Setting(
          "axis", "setFixedAxis", "fixed tool axis",
          "one tool axis for the whole path, from tip to shank, instead of tilt and lead, for machines with three axes or one fixed tilt",
          "0,0,1", s.fixed_axis),
      Setting("max_axis_rate", "setMaxAxisRate", "largest axis rate", "largest turn of the axis per mm of path", "4", s.max_axis_rate)
          .in("degrees/mm", NumberRange::above(0.0).upTo(std::numeric_limits<double>::infinity())),
      Setting("axis_smoothing", "setAxisSmoothing", "smoothing length of the axis",
              "smooths changes of the axis shorter than this along the path", "20", s.axis_smoothing)
          .in("mm", NumberRange::from(0.0))
          .zeroFor("no smoothing"),
      Setting("axis_deviation", "setAxisDeviation", "deviation of the axis",
              "largest change of the tilt by smoothing, on average over its length", "1", s.axis_deviation)
          .in("degrees", NumberRange::above(0.0).below(90.0)),
      Setting("feed", "setFeed", "feed", "feed at the contact", "2500", s.feed).in("mm/min", NumberRange::above(0.0)),
      Setting("acceleration", "setAcceleration", "acceleration", "acceleration of the machine; used for the time of sharp turns", "500",
              s.acceleration)
          .in("mm/s2", NumberRange::above(0.0)),
  };
}

std::vector<Setting>
turnTable(SpiralSettings& s)
{
  return {
      Setting("center", "setCenter", "centre", "centre of a part with one boundary, mm, in the scan's coordinates", "0,0,860", s.centre)
          .zeroFor("found"),
      Setting("start", "setStartPoint", "start point", "the path meets the rim nearest to this place, mm, in the scan's coordinates",
              "1650,0,0", s.start_point)
          .zeroFor("found"),
      Setting("boundaries", "setBoundaryMode", "boundaries", "one: the rim; two: the rim and the longest hole; all: the rim and every hole",
              "two", s.boundary_mode),
      Setting("holes", "setHoleHandling", "holes", "the path runs round holes or over them, or a part with holes is refused", "over",
              s.holes),
      Setting("hole_size", "setHoleSize", "hole size",
              "a hole narrower than this is a gap in the data: the path runs over it, marked; with a mesh one step-over, or six sample "
              "spacings if that is more",
              "8", s.hole_size)
          .in("mm", NumberRange::from(0.0))
          .zeroFor("the size found from the scan"),
      Setting("hole_margin", "setHoleMargin", "hole margin", "distance of the path from holes", "1", s.hole_margin)
          .in("mm", NumberRange::from(0.0))
          .zeroFor("none"),
      Setting("rim_overhang", "setRimOverhang", "overhang at the rim",
              "position of the pass along the rim, so far beyond it; below 0 inside it", "2", s.rim_overhang)
          .in("mm", NumberRange())
          .writtenBy("rim"),
      Setting("direction", "setDirection", "direction", "from the inside outward, or inward", "inward", s.direction),
      Setting("sense", "setSense", "sense", "direction of travel round the part, seen from outside", "cw", s.sense),
      Setting("one_way", "setOneWay", "one-way cutting",
              "cut only in the sense asked for: several passes with lifts between them where loops are side by side", "", s.one_way),
      Setting(
          "method", "setMethod", "method",
          "shortest: radial or constant-scallop, whichever has the shorter predicted machining time; radial: turns about a centre or a "
          "hole; constant-scallop: loops along rim and holes, linked to one path; published: the method of Wu et al. 2025, for comparison",
          "radial", s.method),
      Setting("turn_radius", "setLeastTurnRadius", "least turn radius", "warn of turns with a smaller radius than this, 0 to 0.25", "0.1",
              s.least_turn_radius)
          .in("step-overs", NumberRange::from(0.0).upTo(0.25)),
      Setting("pitch", "setPitch", "pitch",
              "where the distance of turns is measured: across the feed, or along the radial lines as published", "along", s.pitch),
      Setting("lines", "setLineMethod", "method of radial lines", "how radial lines are found", "harmonic", s.lines),
      Setting(
          "tight", "setTightHandling", "tight places",
          "places that the ball does not reach: it rides over them without a gouge, and what stays is reported; or a hollow tighter than "
          "the ball is refused",
          "refuse", s.tight),
      Setting("gaps", "setGapHandling", "gaps", "gaps in the data are bridged or refused", "refuse", s.gaps),
  };
}

std::vector<Setting>
settingTable(SpiralSettings& s)
{
  return cutterTable(s) + turnTable(s) + settingTable(static_cast<SurfaceSettings&>(s));
}

double
lineTolerance(const SpiralSettings& settings)
{
  return 0.02 * std::sqrt(8.0 * settings.scallop_height * settings.tool_radius);
}

double
lineFitTolerance(const SpiralSettings& settings)
{
  return 0.2 * settings.chord_error;
}

} // namespace pcl_spiral
