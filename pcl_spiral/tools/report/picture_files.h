// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The pictures of a run as files for a while: drawn once, then copied to outputs and put into reports.
 */
#pragma once

#include "io/report/report_page.h"
#include <pcl_spiral/machine/machine_program.h>
#include <pcl_spiral/visualization/verification_pictures.h>

#include <string>
#include <vector>

/** What a picture shows. */
enum class PictureKind { Spiral, Lines, Deviation, Stock, Histogram, Rotary };

/** A picture and what is put after an output's name for it: part_stock.png of part.png. */
struct PictureName {
  PictureKind kind;
  std::string suffix;
};

/** A picture that has been drawn. */
struct PictureFile {
  PictureKind kind;
  std::string file;
};

/** Draws into a folder of its own, which goes with the object. Drawing throws Cancelled between two pictures,
 * and pcl_spiral::FileError where the system gives no folder for a while. */
class PictureFiles {
public:
  PictureFiles() = default;
  ~PictureFiles();
  PictureFiles(const PictureFiles&) = delete;
  PictureFiles& operator=(const PictureFiles&) = delete;

  /** The path over the surface and, where \p lines, loops and radial lines. Errors as SpiralPictures has
   * them. */
  void drawPath(const pcl_spiral::PictureScene& scene, bool lines);
  /** Rotary axes along a program. Errors as writeRotaryAngles has them. */
  void drawProgram(const std::string& title, const pcl_spiral::MachineProgram& program);
  /** Deviation, stock, histogram. Errors as VerificationPictures has them. */
  void drawJudging(const pcl_spiral::VerificationScene& scene);

  /** The latest picture of a kind as the file \p file. \throw pcl_spiral::FileError */
  void copy(PictureKind kind, const std::string& file) const;
  /** The latest pictures of these kinds, those that have been drawn. */
  std::vector<pcl_spiral::ReportPicture> forReport(const std::vector<PictureKind>& kinds) const;

private:
  std::string add(PictureKind kind);
  const PictureFile* find(PictureKind kind) const;

  std::string folder_; ///< empty until the first picture
  std::vector<PictureFile> files_;
};

/** \throw pcl_spiral::FileError naming \p output where it holds pictures and there is no display */
void requireDisplay(const std::string& output);
