// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  One run of the generator over one region.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include "outputs.h"

#include "terminal/terminal.h"
#include "terminal/uncut_strips.h"

#include <pcl_spiral/io/file_error.h>

/** A refusal of the surface or of the generator. */
class NoPath : public pcl_spiral::FileError {
public:
  NoPath(const std::string& file, const pcl_spiral::Diagnostic& reason, bool is_late) : FileError(file, reason), late(is_late) {}
  bool late; ///< after turns were made: as slow as a path
};

/** Reads the scan, or the samples of the mesh: what all regions share. */
void readInput(const Job& job, ProgressBar& bar, Result& result);

/** The path over the region that job.part chooses, without its narrow \p strips beside keep-outs. \p result has what readInput gave.
 *  \throw NoPath
 *  \throw EntersKeepOut, and what requireFreeWay throws */
Result planned(const Job& job, const StripChoice& strips, ProgressBar& bar, Result result);
