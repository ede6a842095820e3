// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Whether the ball or its shank enters what is not to be cut.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include "job.h"
#include "outputs.h"

#include <pcl_spiral/collision/surroundings.h>
#include <pcl_spiral/io/file_error.h>

#include <optional>

/** A path on which the ball enters a keep-out. */
class EntersKeepOut : public pcl_spiral::FileError {
public:
  EntersKeepOut(const std::string& file, const pcl_spiral::Diagnostic& reason, double room, bool crosses)
  : FileError(file, reason), room_(room), crosses_(crosses)
  {}
  double room() const { return room_; }     ///< how much farther away the ball should stay, mm
  bool crosses() const { return crosses_; } ///< the path does not only run a little beyond the last points

private:
  double room_;
  bool crosses_;
};

/** What the scan has beside the part, and the keep-outs. */
pcl_spiral::Surroundings surroundingsOf(const Result& result);

/** Does nothing if the way is not \p blocked.
 *  \throw EntersKeepOut
 *  \throw pcl_spiral::FileError if ball or shank cut into something else; both with the message of \p status */
void requireFreeWay(const Job& job, const pcl_spiral::Status& status, const std::optional<pcl_spiral::BlockedWay>& blocked);

/** Says what smoothing moved, if there is a raw scan, and warns where the ball cuts into its points.
 *  \throw pcl_spiral::FileError if it does and the path is judged (--verify); if the raw scan cannot be read */
void checkRawScan(const Job& job, Result& result);
