// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Output files of passes: paths, programs, lists of poses.
 */
#pragma once

#include "pass_job.h"
#include "pass_result.h"

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/io/output_files.h>
#include <pcl_spiral/io/toolpath_writer.h>

#include <cstddef>
#include <functional>
#include <string>

/** Whether \p output can be written, by its extension. */
bool isPassFile(const std::string& output);

/** Writes \p file in the format of \p output; not for pictures and reports. \throw pcl_spiral::FileError */
void writePassFile(const PassJob& job, const PassResult& result, const std::string& title, const std::string& output,
                   const std::string& file);

/** Calls \p write for every output, with its name and the number of its first file in \p files, which \p write increases. Then
 *  renames all files to their final names. \throw std::runtime_error, Cancelled: then no output has changed */
void writeAll(const PassJob& job, pcl_spiral::OutputFiles& files,
              const std::function<void(const std::string& output, std::size_t& next)>& write);
