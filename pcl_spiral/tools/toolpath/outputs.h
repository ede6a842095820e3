// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What a run of pcl_spiral_toolpath came to, and its files.
 */
#pragma once

#include "job.h"
#include "judging/judge.h"

#include "io/output_files.h"
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/machine/machine_program.h>
#include <pcl_spiral/mesh/surface_mesh.h>
#include <pcl_spiral/spiral/spiral_report.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/** A mesh, and the samples that the path was planned on. */
struct MeshInput {
  pcl_spiral::SurfaceMesh::ConstPtr mesh;         ///< the parts that the path runs over
  pcl_spiral::MeshCounts counts;                  ///< of the mesh as given
  double spacing = 0.0;                           ///< of the samples, mm
  pcl::PointCloud<pcl::Normal>::ConstPtr normals; ///< of the samples
  std::vector<std::uint32_t> faces;               ///< of the mesh as given, one a sample
};

/** All that a run came to. */
struct Result {
  pcl_spiral::Scan scan; ///< or the samples of the mesh
  std::optional<MeshInput> mesh;
  pcl_spiral::SpiralSettings settings; ///< as used
  pcl::PointCloud<pcl_spiral::ToolpathPoint>::Ptr path = pcl::make_shared<pcl::PointCloud<pcl_spiral::ToolpathPoint>>();
  pcl_spiral::SpiralReport report;
  pcl_spiral::Surface::ConstPtr surface;                ///< of the samples of the mesh; or of the scan, where planner and judge share one
  std::optional<pcl_spiral::Verification> verification; ///< where the path was judged, and then
  Heights heights;                                      ///< the values behind it
  std::optional<pcl_spiral::MachineProgram> program;    ///< where a machine is given
};

/** Warnings of reading, planning and judging. */
std::vector<std::string> warningsOf(const Result& result);

/** Writes every file of the job, all or none; reports last, so that they tell what drawing and writing cost, which is
 * added to the stages of \p result. \throw pcl_spiral::FileError, Cancelled */
void writeOutputs(const Job& job, Result& result, pcl_spiral::OutputFiles& files);
