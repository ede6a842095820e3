// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The option for the surface after cutting.
 */
#pragma once

#include <string>
#include <vector>

constexpr const char* stock_help =
    "the surface after cutting: a mesh, .ply with the height left at each vertex as stock, mm, negative for a gouge, or .stl; may be given "
    "several times: --stock left.ply --stock left.stl";

/** \throw UsageError for another extension */
void checkStockFiles(const std::vector<std::string>& files);
