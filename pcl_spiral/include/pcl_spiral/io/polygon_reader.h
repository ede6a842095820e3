// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Reader of polygons.
 */
#pragma once

#include <pcl_spiral/core/prism.h>
#include <pcl_spiral/io/cloud_reader.h>

#include <string>

namespace pcl_spiral {

/** Reads a polygon from a text file, one corner per line, in order; the last corner is connected to the first. Lines that start
 *  with # or //, and a heading, are passed over; numbers are separated by commas, semicolons or blanks.
 *
 *  x y: the polygon is extended along z. x y z: it is extended along its mean normal. The numbers are in the unit of the scan and
 *  before \p options.origin is subtracted, as those in the file of the scan; columns is not used.
 *  \throw FileError with the line and the reason: missing, not a number, fewer than two numbers in a line, lines with and
 *  without z, or no area */
Prism readPolygon(const std::string& file, const ReadOptions& options = {});

} // namespace pcl_spiral
