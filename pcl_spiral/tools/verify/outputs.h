// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What a run of pcl_spiral_verify came to, and its files.
 */
#pragma once

#include "judging/judged_part.h"
#include "verify_job.h"

#include "io/output_files.h"
#include <pcl_spiral/io/toolpath_reader.h>

/** A path and how it was judged. */
struct JudgedPath {
  pcl::PointCloud<pcl_spiral::ToolpathPoint>::Ptr path = pcl::make_shared<pcl::PointCloud<pcl_spiral::ToolpathPoint>>();
  std::vector<double> feed; ///< mm/min; empty where its file has none
  pcl_spiral::Verification verification;
  Heights heights;
};

/** Collects what is told of each path, then writes. */
class VerifyOutputs {
public:
  /** Checks that every file can be written and that there is a display where one is needed.
   *  \throw pcl_spiral::FileError */
  explicit VerifyOutputs(const VerifyJob& job);

  /** Draws its pictures, where any are asked for, and writes it where it is asked for as .vtp. */
  void take(const JudgedPart& part, const pcl_spiral::ReferenceSurface& surface, const JudgedPath& judged);
  /** Writes the rest and puts all files in their places. \throw pcl_spiral::FileError, Cancelled */
  void finish(const JudgedPart& part);

private:
  const VerifyJob& job_;
  std::optional<pcl_spiral::JudgedMesh> mesh_; ///< absent: a scan
  pcl_spiral::OutputFiles files_;
  PictureFiles pictures_;
  std::vector<pcl_spiral::Verification> verifications_;
  std::vector<std::vector<pcl_spiral::ReportPicture>> report_pictures_; ///< of each path
};
