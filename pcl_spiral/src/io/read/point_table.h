// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Named columns of numbers from point files.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include <Eigen/Core>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pcl_spiral {

/** One column of values for each wanted name, in that order; all of the same length. */
using PointTable = std::vector<std::vector<double>>;

using Names = std::vector<std::string>;

/** Whether a reader adds the columns of normals, if the file names all three, behind the wanted ones. */
enum class NormalColumns { Leave, Read };

/** What a user says of a text, and what was found in it. */
struct TextLayout {
  Names columns;                   ///< from the left; empty: the header names them, otherwise the first ones are the wanted
  std::size_t skipped = 0;         ///< lines at the beginning that are not read
  Diagnostics* warnings = nullptr; ///< gets what is told of lines that were passed over
};

/** \p bytes is the content of \p file; the name is for messages. Each reader throws FileError if a
 * wanted column is missing, a value is not a number, or the file ends too early.
 *  @{ */
PointTable readPcdTable(const std::string& file, std::string_view bytes, const Names& wanted, NormalColumns normals = NormalColumns::Leave);
PointTable readPlyTable(const std::string& file, std::string_view bytes, const Names& wanted, NormalColumns normals = NormalColumns::Leave);
PointTable readTextTable(const std::string& file, std::string_view bytes, const Names& wanted, const TextLayout& layout = {},
                         NormalColumns normals = NormalColumns::Leave);
/** Vertices x y z. */
PointTable readObjTable(const std::string& file, std::string_view bytes);
/** Corners x y z of the triangles, each point once. */
PointTable readStlTable(const std::string& file, std::string_view bytes);
/** x y z of uncompressed points that are not flagged withheld; \p warnings gets the number of those that are. */
PointTable readLasTable(const std::string& file, std::string_view bytes, Diagnostics& warnings);
/** x y z of a text that begins with the number of its points, perhaps below a title; several such blocks may follow each other.
 *  The columns of \p layout are not used. */
PointTable readPtsTable(const std::string& file, std::string_view bytes, const TextLayout& layout = {});
/** Points, Normals, ToolAxis, ArcLength, Turn and, if present, Feed of a polyline written by this library. OverGap and Lift, if present,
 *  are the last columns: \p later gets their names in other formats. */
PointTable readVtpTable(const std::string& file, std::string_view bytes, Names& later);
/** The columns of Tip, if present. */
PointTable readVtpTips(const std::string& file, std::string_view bytes);
/** First points of its second and of each further polyline; the points of all polylines are in order. */
std::vector<std::size_t> readVtpPasses(const std::string& file, std::string_view bytes);
/** @} */

/** Whether a file with this content is an STL file: ascii, or binary of the right size. */
bool isStl(std::string_view bytes);

/** How to convert a scan in a format that is not read, as the end of a message. */
std::string conversionRemedy(const std::string& file);

/** The position in VIEWPOINT of a PCD file with the points \p table, in the unit of the file; absent for the default 0 0 0 1 0 0 0, unless
 *  the cloud is organised and was seen from there (seenFromOrigin). \throw FileError */
std::optional<Eigen::Vector3d> readPcdViewPoint(const std::string& file, std::string_view bytes, const PointTable& table);

/** \p wanted, then the three columns of normals if \p names has them: nx ny nz, or normal_x normal_y normal_z. */
Names withNormals(const Names& names, const Names& wanted);

/** Position of each wanted name in \p names, upper or lower case. \throw FileError with the names of the file
 */
std::vector<std::size_t> columnsOf(const std::string& file, const Names& names, const Names& wanted);

} // namespace pcl_spiral
