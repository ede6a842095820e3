// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What cutters are located on, as CutterLocationEngine sees it. Private.
 */
#pragma once

#include <pcl_spiral/common/drive_pass.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/impl/swept_error.h>
#include <pcl_spiral/cutter/tool_location.h>

#include <cstddef>

namespace pcl_spiral {

/** One cutter with what holds it, on one scan or mesh. */
class LocationGround {
public:
  virtual ~LocationGround() = default;

  /** Whether locations can be found as asked. */
  virtual Status check() const = 0;

  /** One location a drive point; the same for any number of threads. */
  virtual void locate(const DrivePoint* drive, std::size_t count, ToolLocation* locations) const = 0;

  /** Whether the cutter and what holds it can stand at the contact that \p drive asks for: a quick test, by the points or by
   * the surface alone. */
  virtual bool clears(const DrivePoint& drive) const = 0;

  /** Bound of how deep a straight move may cut, tip and axis led evenly; \p allowed where it is known to be no more than that. */
  virtual double moveError(const CutterPlace& from, const CutterPlace& to, double allowed) const = 0;

  /** What figures and warnings there are besides those of all grounds, which \p figures has. */
  virtual void describe(const ToolLocations& locations, LocationFigures& figures) const = 0;

  /** What it is, for messages: "scan"; and of what the cutter meets: "point". */
  virtual const char* name() const = 0;
  virtual const char* item() const = 0;
};

} // namespace pcl_spiral
