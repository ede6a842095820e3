// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The result of pcl_spiral_toolpath and its output files.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include "job.h"
#include "judging/judge.h"
#include "terminal/part_choice.h"
#include "terminal/scan_side.h"

#include "io/output_files.h"
#include "verify/stock_mesh.h"
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/machine/machine_program.h>
#include <pcl_spiral/machine/tool_moves.h>
#include <pcl_spiral/mesh/surface_mesh.h>
#include <pcl_spiral/spiral/spiral_report.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/** A mesh, and the samples used to plan the path. */
struct SampledMesh {
  pcl_spiral::SurfaceMesh::ConstPtr mesh;         ///< the parts that the path runs over
  pcl_spiral::MeshCounts counts;                  ///< of the mesh as given
  double spacing = 0.0;                           ///< of the samples, mm
  pcl::PointCloud<pcl::Normal>::ConstPtr normals; ///< of the samples
  std::vector<std::uint32_t> faces;               ///< of the mesh as given, one per sample
};

/** The ways of the tool from region to region. Lengths in mm. */
struct RegionLinks {
  std::size_t count = 0;
  double height = 0.0; ///< of the highest tip, along the direction of the first rotary axis
};

/** The result of a run, or of one region of it. */
struct Result {
  std::string region;                                  ///< its name; empty: the run
  std::vector<Result> regions;                         ///< if there are several; all else is then of all together
  RegionLinks links;                                   ///< between the regions
  pcl_spiral::Scan scan;                               ///< or the samples of the mesh
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr whole_scan; ///< with what the choice of the part left out
  pcl_spiral::SurfaceMesh::ConstPtr whole_mesh;        ///< with the parts that the path does not run over; null for a scan
  std::vector<Eigen::Vector3f> echoes;                 ///< clusters that are left out as false echoes, if a holder is given
  ChosenPart part;
  ScanSide side; ///< what decides the side of the scan
  std::optional<SampledMesh> mesh;
  pcl_spiral::SpiralSettings settings; ///< as used
  pcl::PointCloud<pcl_spiral::ToolpathPoint>::Ptr path = pcl::make_shared<pcl::PointCloud<pcl_spiral::ToolpathPoint>>();
  pcl_spiral::SpiralReport report;
  pcl_spiral::Surface::ConstPtr surface; ///< of the samples of the mesh; or of the scan, if planning and verification share one
  std::optional<pcl_spiral::Verification> verification; ///< if the path was judged
  Heights heights;                                      ///< the values behind it
  pcl_spiral::StockMesh left;                           ///< the surface after cutting, with --stock
  std::optional<pcl_spiral::MachineProgram> program;    ///< if a machine is given
  std::vector<pcl_spiral::ToolMoves> moves;             ///< with leads, if an output is CLDATA or has robot frames
};

/** Warnings of reading, planning and judging. */
pcl_spiral::Diagnostics warningsOf(const Result& result);

/** Writes all files of the job, or none. Reports come last: they contain the time of drawing and writing, which is
 * added to the stages of \p result. \throw pcl_spiral::FileError, Cancelled */
void writeOutputs(const Job& job, Result& result, pcl_spiral::OutputFiles& files);
