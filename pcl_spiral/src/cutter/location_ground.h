// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The surface on which CutterLocationEngine locates cutters. Private.
 */
#pragma once

#include <pcl_spiral/common/drive_pass.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/impl/swept_error.h>
#include <pcl_spiral/core/tool_holder.h>
#include <pcl_spiral/cutter/tool_location.h>

#include <cstddef>

namespace pcl_spiral {

/** One cutter with its holder, on one scan or mesh. */
class LocationGround {
public:
  virtual ~LocationGround() = default;

  /** Whether locations can be found with these settings. */
  virtual Status check() const = 0;

  /** One location a drive point; the same for any number of threads. */
  virtual void locate(const DrivePoint* drive, std::size_t count, ToolLocation* locations) const = 0;

  /** Whether the cutter and \p holder fit at the contact given by \p drive, lifted by no more than \p slack: a quick test with only
   *  the points or only the surface. */
  virtual bool clears(const DrivePoint& drive, double slack, const HolderProfile& holder) const = 0;

  /** How far along the axis, mm, a cutter may be held off the contact given by \p drive and still touch it, with the noise of points. */
  virtual double slackAt(const DrivePoint& drive) const = 0;

  /** Bound of how deep a straight move may cut, with tip and axis moving evenly; \p allowed if it is known to be at most that. */
  virtual double moveError(const CutterPlace& from, const CutterPlace& to, double allowed) const = 0;

  /** Add the figures and warnings of this kind of ground to \p figures, which has the common ones. */
  virtual void describe(const ToolLocations& locations, LocationReport& figures) const = 0;

  /** For messages: its name, "scan", and the name of the items that the cutter meets, "point". */
  virtual const char* name() const = 0;
  virtual const char* item() const = 0;
};

} // namespace pcl_spiral
