// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Named columns of numbers out of point files.
 */
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pcl_spiral {

/** One column of values for each wanted name, in the order wanted; all of one length. */
using PointTable = std::vector<std::vector<double>>;

using Names = std::vector<std::string>;

/** \p bytes is the content of \p file; the name serves the messages. Each reader throws FileError where a
 * wanted column is missing, a value is no number, or the file ends early.
 *  @{ */
PointTable readPcdTable(const std::string& file, std::string_view bytes, const Names& wanted);
PointTable readPlyTable(const std::string& file, std::string_view bytes, const Names& wanted);
/** \p columns names the columns from the left; empty: by the file's header, else the first columns are the
 * wanted. */
PointTable readTextTable(const std::string& file, std::string_view bytes, const Names& wanted, const Names& columns = {});
/** Vertices x y z. */
PointTable readObjTable(const std::string& file, std::string_view bytes);
/** Corners x y z of the triangles, each point once. */
PointTable readStlTable(const std::string& file, std::string_view bytes);
/** Points, Normals, ToolAxis, ArcLength, Turn, and Feed where there is one, of a polyline as our writer makes it. */
PointTable readVtpTable(const std::string& file, std::string_view bytes);
/** Points at which its second polyline begins, and each further one; each goes on in the order of the points. */
std::vector<std::size_t> readVtpPasses(const std::string& file, std::string_view bytes);
/** @} */

/** Where each wanted name stands in \p names, upper or lower case. \throw FileError with the names there are
 */
std::vector<std::size_t> columnsOf(const std::string& file, const Names& names, const Names& wanted);

} // namespace pcl_spiral
