// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The report of a run, as JSON and as a page for people.
 */
#pragma once

#include "verification_writer.h"
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/mesh/surface_mesh.h>
#include <pcl_spiral/spiral/spiral_report.h>
#include <pcl_spiral/spiral/spiral_settings.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl_spiral {

/** A mesh whose samples are a run's points. */
struct RunMesh {
  MeshCounts counts;
  double sample_spacing = 0.0; ///< mm
};

/** Where a run's points came from and where its path went. */
struct RunFiles {
  std::string scan;
  LengthUnit unit = LengthUnit::Millimetre;         ///< of the numbers in the scan
  Eigen::Vector3d origin = Eigen::Vector3d::Zero(); ///< subtracted from the scan, mm
  std::vector<std::string> outputs;
  std::vector<std::string> warnings; ///< from reading
  std::optional<RunMesh> mesh;       ///< where the points are samples of one
};

/** Input, settings, loops, counts, time and memory of each stage and warnings of a run, and the path's figures where it was
 * judged (null: not). Lengths mm, angles degrees, seconds, MB (10^6 bytes; see MemoryUse). \throw FileError */
void writeReportJSON(const std::string& file, const RunFiles& files, const SpiralSettings& settings, const SpiralReport& report,
                     const Verification* verification = nullptr);

/** The same as one HTML file that needs no other, with \p pictures of the path and \p judged of how it was judged.
 *  \throw FileError */
void writeReportHTML(const std::string& file, const ReportPage& page, const RunFiles& files, const SpiralSettings& settings,
                     const SpiralReport& report, const std::vector<ReportPicture>& pictures, const Verification* verification = nullptr,
                     const std::vector<ReportPicture>& judged = {});

} // namespace pcl_spiral
