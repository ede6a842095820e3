// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Options for scan and cutter, shared by the programs that judge paths.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include "terminal/region_choice.h"
#include <pcl_spiral/planning/impl/path_judging.h>

#include <pcl_spiral/io/cloud_reader.h>

#include <boost/program_options.hpp>

#include <optional>

/** Reads the arguments. Option names are written in full; arguments without a name are "file". \throw UsageError */
boost::program_options::variables_map readArguments(int argc, const char* const* argv,
                                                    const boost::program_options::options_description& options);

/** Settings for a part given as a mesh. */
struct MeshChoice {
  pcl_spiral::MeshSettings settings;
  double sample_spacing = 0.0; ///< mm; 0: chosen automatically
};

/** --units, --origin, --columns, --skip-lines */
void addScanOptions(boost::program_options::options_description& options);

/** --tool-radius with \p radius_meaning as its help, --corner-radius, --flank-length, --flank-angle,
 * --scallop, --chord-error, --view-point, --flip-normals */
void addCutterOptions(boost::program_options::options_description& options, const char* radius_meaning);

/** --part-at, --region, --crop, --keep-out, --clusters */
void addPartOptions(boost::program_options::options_description& options);

/** Crop and keep-outs. */
PartOptions partOptions(const boost::program_options::variables_map& given);

/** The regions. \throw UsageError */
RegionChoice regionChoice(const boost::program_options::variables_map& given);

/** How to read the scan. \throw UsageError */
pcl_spiral::ReadOptions scanOptions(const boost::program_options::variables_map& given);

/** --mesh, --crease-angle, --sample-spacing; --flip-normals of addCutterOptions turns a mesh over, too */
void addMeshOptions(boost::program_options::options_description& options);

/** Settings of the mesh; none without --mesh. \throw UsageError if an option does not fit the part */
std::optional<MeshChoice> meshOptions(const boost::program_options::variables_map& given);

/** Cutter, finish and --threads; the radius of the cutter is 0 if it is not given. \throw UsageError if values do not fit each
 * other */
pcl_spiral::JudgeSettings cutterOptions(const boost::program_options::variables_map& given);

/** \throw UsageError with \p message unless \p holds */
void require(bool holds, const pcl_spiral::Diagnostic& message);
