// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The time series of a judged path.
 */
#pragma once

#include "verify_job.h"

#include <pcl_spiral/io/output_files.h>
#include <pcl_spiral/planning/impl/path_judge.h>

#include <string>
#include <vector>

/** The files of a series NAME.pvd: itself, then NAME_00.vtp and so on. */
std::vector<std::string> seriesFiles(const std::string& output);

/** Writes the series whose files begin at \p first of \p files. \throw pcl_spiral::FileError, also if the path cannot be put in time */
void writeCutSeries(const VerifyJob& job, const pcl_spiral::ReferenceSurface& surface, const pcl_spiral::JudgedPath& judged,
                    const FiledPath& filed, pcl_spiral::OutputFiles& files, std::size_t first);
