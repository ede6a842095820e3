// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The pictures of a run as temporary files: drawn once, then copied to outputs and put into reports.
 */
#pragma once

#include <pcl_spiral/io/report_page.h>
#include <pcl_spiral/machine/machine_program.h>
#include <pcl_spiral/visualization/pass_picture.h>
#include <pcl_spiral/visualization/reach_picture.h>
#include <pcl_spiral/visualization/verification_pictures.h>

#include <string>
#include <vector>

/** Description of a picture. */
enum class PictureKind { Spiral, Lines, Passes, Deviation, Stock, Histogram, Rotary, Reach };

/** A picture and its suffix after an output's name: part_stock.png of part.png. */
struct PictureName {
  PictureKind kind;
  std::string suffix;
};

/** A drawn picture. */
struct PictureFile {
  PictureKind kind;
  std::string file;
};

/** Draws into its own temporary folder, which the destructor removes. Drawing throws Cancelled between two pictures,
 * and pcl_spiral::FileError if the temporary folder cannot be made. */
class PictureFiles {
public:
  PictureFiles() = default;
  ~PictureFiles();
  PictureFiles(const PictureFiles&) = delete;
  PictureFiles& operator=(const PictureFiles&) = delete;

  /** The path on the surface and, if \p lines, loops and radial lines. Errors as in
   * SpiralPictures. */
  void drawPath(const pcl_spiral::PictureScene& scene, bool lines);
  /** Passes on the part. Errors as in writePasses. */
  void drawPasses(const pcl_spiral::PassScene& scene);
  /** The largest balls. Errors as in writeReach. */
  void drawReach(const pcl_spiral::ReachScene& scene);
  /** Rotary axes along a program. Errors as in writeRotaryAngles. */
  void drawProgram(const std::string& title, const pcl_spiral::MachineProgram& program);
  /** Deviation, stock, histogram. Errors as in VerificationPictures. */
  void drawJudging(const pcl_spiral::VerificationScene& scene);

  /** Copies the latest picture of a kind to \p file. \throw pcl_spiral::FileError */
  void copy(PictureKind kind, const std::string& file) const;
  /** The latest drawn pictures of these kinds. */
  std::vector<pcl_spiral::ReportPicture> forReport(const std::vector<PictureKind>& kinds) const;

private:
  std::string add(PictureKind kind);
  const PictureFile* find(PictureKind kind) const;

  std::string folder_; ///< empty until the first picture
  std::vector<PictureFile> files_;
};

/** \throw pcl_spiral::FileError that names \p output if it needs pictures and there is no display */
void requireDisplay(const std::string& output);
