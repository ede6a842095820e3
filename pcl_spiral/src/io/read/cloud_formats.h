// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The formats of scans. A new one needs a line in the table here, and a file read_NAME.cpp with its reader.
 */
#pragma once

#include "point_table.h"

#include <array>
#include <string>
#include <string_view>

namespace pcl_spiral {

/** What a user may say of a text. */
enum class TextUse {
  None,   ///< a binary file
  Plain,  ///< text whose lines cannot be skipped
  Lines,  ///< its first lines can be skipped
  Columns ///< and its columns named
};

/** One format: what its files are called, and how they are read. */
struct CloudFormat {
  std::string_view extension; ///< with the dot, in small letters
  TextUse use;                ///< Plain: may have a heading in text before binary data
  /** Columns x y z, and those of normals behind them where the file has them. \throw FileError */
  PointTable (*read)(const std::string& file, std::string_view bytes, const TextLayout& layout);
};

inline PointTable
readColumns(const std::string& file, std::string_view bytes, const TextLayout& layout)
{
  return readTextTable(file, bytes, {"x", "y", "z"}, layout, NormalColumns::Read);
}

/** All formats, in the order of messages. */
inline constexpr std::array cloud_formats{
    CloudFormat{".pcd", TextUse::Plain,
                [](const std::string& file, std::string_view bytes, const TextLayout&) {
                  return readPcdTable(file, bytes, {"x", "y", "z"}, NormalColumns::Read);
                }},
    CloudFormat{".ply", TextUse::Plain,
                [](const std::string& file, std::string_view bytes, const TextLayout&) {
                  return readPlyTable(file, bytes, {"x", "y", "z"}, NormalColumns::Read);
                }},
    CloudFormat{".xyz", TextUse::Columns, readColumns},
    CloudFormat{".txt", TextUse::Columns, readColumns},
    CloudFormat{".csv", TextUse::Columns, readColumns},
    CloudFormat{".asc", TextUse::Columns, readColumns},
    CloudFormat{".pts", TextUse::Lines, readPtsTable},
    CloudFormat{".las", TextUse::None,
                [](const std::string& file, std::string_view bytes, const TextLayout& layout) {
                  return readLasTable(file, bytes, *layout.warnings);
                }},
    CloudFormat{".stl", TextUse::None,
                [](const std::string& file, std::string_view bytes, const TextLayout&) { return readStlTable(file, bytes); }},
    CloudFormat{".obj", TextUse::Plain,
                [](const std::string& file, std::string_view bytes, const TextLayout&) { return readObjTable(file, bytes); }}};

} // namespace pcl_spiral
