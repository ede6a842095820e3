// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Results and output files of a run of pcl_spiral_verify.
 */
#pragma once

#include "judging/judged_part.h"
#include "verify_job.h"

#include "io/output_files.h"
#include "io/report/verification_writer.h"
#include <pcl_spiral/io/toolpath_reader.h>

/** A path and its judgement. */
struct JudgedPath {
  pcl::PointCloud<pcl_spiral::ToolpathPoint>::Ptr path = pcl::make_shared<pcl::PointCloud<pcl_spiral::ToolpathPoint>>();
  std::vector<double> feed;  ///< mm/min; empty if its file has none
  pcl_spiral::Polyline tips; ///< of a cutter that is no ball; empty: from its contacts
  pcl_spiral::Verification verification;
  pcl_spiral::Heights heights;
};

/** Collects the results of each path, then writes the files. */
class VerifyOutputs {
public:
  /** Checks that every file can be written and that there is a display if one is needed.
   *  \throw pcl_spiral::FileError */
  explicit VerifyOutputs(const VerifyJob& job);

  /** Draws the pictures and writes the .vtp file of a path, if they were asked for. */
  void take(const JudgedPart& part, const pcl_spiral::ReferenceSurface& surface, const JudgedPath& judged);
  /** Writes the other files and moves all files to their places. \throw pcl_spiral::FileError, Cancelled */
  void finish(const std::vector<JudgedPart>& parts);

private:
  const VerifyJob& job_;
  std::optional<pcl_spiral::JudgedMesh> mesh_; ///< absent: a scan
  pcl_spiral::OutputFiles files_;
  PictureFiles pictures_;
  std::vector<pcl_spiral::Verification> verifications_;
  std::vector<std::vector<pcl_spiral::ReportPicture>> report_pictures_; ///< of each path
};
