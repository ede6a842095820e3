// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The program's words for what the library says: options, places as the scan file has them, and a mesh where the part is one.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include <string>
#include <vector>

/** The options of the program, without the dashes. Each program defines it. */
std::vector<std::string> ownOptions();

/** From now on what is said of a scan is said of a mesh: the points of this run are samples of one. */
void speakOfMesh();

/** Options for setters; a setter that the program has no option for has no name. Places in the coordinates of the scan, see scan_places.h,
 *  with those of the file behind them if they differ. */
pcl_spiral::Vocabulary programWords();

/** The text in the program's words. */
std::string inWords(const pcl_spiral::Diagnostic& diagnostic);
