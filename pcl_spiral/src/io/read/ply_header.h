// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The header of a PLY file.
 */
#pragma once

#include "field_layout.h"
#include "text_scan.h"

#include <string>
#include <vector>

namespace pcl_spiral {

struct PlyProperty {
  std::string name;
  FieldType type;
  bool list = false;
  FieldType count_type;
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;

  std::vector<std::string> propertyNames() const;
  bool hasLists() const;
};

struct PlyHeader {
  std::vector<PlyElement> elements;
  bool ascii = true;
  bool swapped = false; ///< binary in the other byte order
};

/** Whether the next line of \p lines holds one record of the first element, as far as its number of words tells. */
bool beginsWithRecord(const PlyHeader& header, LineScanner lines);

/** Reads up to end_header; \p lines is then at the next line. \throw FileError */
PlyHeader readPlyHeader(const std::string& file, LineScanner& lines);

} // namespace pcl_spiral
