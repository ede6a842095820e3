// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Results and output files of a run of pcl_spiral_verify.
 */
#pragma once

#include "verify_job.h"

#include "io/report/scene_builder.h"
#include <pcl_spiral/io/output_files.h>
#include <pcl_spiral/io/scene_writer.h>
#include <pcl_spiral/io/verification_writer.h>
#include <pcl_spiral/planning/impl/path_judge.h>
#include <pcl_spiral/verify/stock_mesh.h>

/** Collects the results of each path, then writes the files. */
class VerifyOutputs {
public:
  /** Checks that every file can be written and that there is a display if one is needed.
   *  \throw pcl_spiral::FileError */
  explicit VerifyOutputs(const VerifyJob& job);

  /** Draws the pictures and writes the files of a path alone, if they were asked for. \throw pcl_spiral::FileError */
  void take(const pcl_spiral::JudgedInput& input, const pcl_spiral::JudgedPart& part, const pcl_spiral::JudgedPath& judged,
            const FiledPath& filed);
  /** Writes the other files and moves all files to their places. \p warnings: of the scan. \throw pcl_spiral::FileError, Cancelled */
  void finish(const pcl_spiral::Diagnostics& warnings);

private:
  pcl_spiral::CutScene cutScene(const pcl_spiral::ReferenceSurface& surface, const pcl_spiral::JudgedPath& judged) const;
  void addToScene(const pcl_spiral::JudgedInput& input, const pcl_spiral::JudgedPart& part, const pcl_spiral::JudgedPath& judged,
                  const std::vector<double>& feed, const std::optional<pcl_spiral::ProgramFile>& program);

  const VerifyJob& job_;
  std::optional<pcl_spiral::JudgedMesh> mesh_; ///< absent: a scan
  pcl_spiral::OutputFiles files_;
  PictureFiles pictures_;
  pcl_spiral::StockMesh left_; ///< of the path, over all regions
  std::vector<pcl_spiral::Verification> verifications_;
  std::vector<std::vector<pcl_spiral::ReportPicture>> report_pictures_; ///< of each path
  std::unique_ptr<pcl_spiral::SceneBuilder> scene_;                     ///< of the first path over all regions; null: no page
};
