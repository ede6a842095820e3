// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Whether the ball or its shank enters what is not to be cut.
 */
#pragma once

#include "job.h"
#include "outputs.h"

#include <pcl_spiral/io/file_error.h>

/** A path on which the ball enters a keep-out. */
class EntersKeepOut : public pcl_spiral::FileError {
public:
  EntersKeepOut(const std::string& file, const std::string& reason, double room, bool crosses)
  : FileError(file, reason), room_(room), crosses_(crosses)
  {}
  double room() const { return room_; }     ///< how much farther away the ball should stay, mm
  bool crosses() const { return crosses_; } ///< the path does not only run a little beyond the last points

private:
  double room_;
  bool crosses_;
};

/** Warns of single points beside the part in the way, which are taken for false echoes.
 *  \throw EntersKeepOut
 *  \throw pcl_spiral::FileError if the shank cuts into what stands in a keep-out, or ball or shank into the scan beside the part */
void checkWay(const Job& job, Result& result);

/** Says what smoothing moved, if there is a raw scan, and warns where the ball cuts into its points.
 *  \throw pcl_spiral::FileError if it does and the path is judged (--verify); if the raw scan cannot be read */
void checkRawScan(const Job& job, Result& result);
