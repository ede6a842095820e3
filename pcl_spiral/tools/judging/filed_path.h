// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Paths and programs that are judged, as their files hold them.
 */
#pragma once

#include "terminal/option_table.h"

#include <pcl_spiral/io/program_writer.h>
#include <pcl_spiral/planning/impl/path_judge.h>

#include <optional>
#include <string>
#include <vector>

/** How programs are read. */
struct ProgramReading {
  std::string machine_file;                   ///< of programs; empty: none
  std::optional<pcl_spiral::Dialect> dialect; ///< of .nc programs; absent: found from their words
};

/** A path or a program, and the feed of its points, if its file has one. */
struct FiledPath {
  pcl_spiral::GivenPath path;
  std::vector<double> feed;
};

/** Whether \p file is a program, by its extension: .ngc .nc .mpf .h .apt .cls */
bool isProgramFile(const std::string& file);

/** --dialect */
Option dialectOption(ProgramReading& reading);

/** Whether programs among \p paths can be read so: they need their machine, and are judged by a scan. \p mesh: it is a mesh. \throw
 *  UsageError */
void checkProgramFiles(const std::vector<std::string>& paths, const ProgramReading& reading, bool mesh);

/** \throw pcl_spiral::FileError */
FiledPath readFiledPath(const std::string& file, const ProgramReading& reading);
