// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The options of scan and cutter, for every program that judges paths.
 */
#pragma once

#include "judge.h"

#include <pcl_spiral/io/cloud_reader.h>

#include <boost/program_options.hpp>

#include <optional>

/** The arguments by \p options, names written in full; those without a name are "file". \throw UsageError */
boost::program_options::variables_map readArguments(int argc, const char* const* argv,
                                                    const boost::program_options::options_description& options);

/** How a part given as a mesh is taken. */
struct MeshChoice {
  pcl_spiral::MeshSettings settings;
  double sample_spacing = 0.0; ///< mm; 0: as it is chosen
};

/** --units, --origin, --columns */
void addScanOptions(boost::program_options::options_description& options);

/** --tool-radius, described as \p radius_meaning, --scallop, --chord-error, --view-point, --flip-normals */
void addCutterOptions(boost::program_options::options_description& options, const char* radius_meaning);

/** How to read the scan. \throw UsageError */
pcl_spiral::ReadOptions scanOptions(const boost::program_options::variables_map& given);

/** --mesh, --crease-angle, --sample-spacing; the side of a mesh is --flip-normals, too */
void addMeshOptions(boost::program_options::options_description& options);

/** How a part given as a mesh is taken; none without --mesh. \throw UsageError where an option does not go with the part */
std::optional<MeshChoice> meshOptions(const boost::program_options::variables_map& given);

/** Cutter, finish and --threads; the tool radius is 0 where none is given. \throw UsageError for values that
 * do not fit one another */
JudgeSettings cutterOptions(const boost::program_options::variables_map& given);

/** \throw UsageError with \p message unless \p holds */
void require(bool holds, const std::string& message);
