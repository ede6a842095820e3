// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Figures of toolpaths judged by a scan, as JSON and as a page for people.
 */
#pragma once

#include "report_page.h"
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/mesh/surface_mesh.h>
#include <pcl_spiral/verify/impl/deviation_estimation_engine.h>
#include <pcl_spiral/verify/impl/material_removal_engine.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl_spiral {

/** What a path must keep; absent: anything goes. */
struct Limits {
  std::optional<double> gouge;     ///< mm
  std::optional<double> scallop;   ///< mm
  std::optional<double> deviation; ///< mm
  std::optional<double> uncut;     ///< percent of the reference points
  bool any() const { return gouge || scallop || deviation || uncut; }
};

/** A toolpath's figures. */
struct Verification {
  std::string path; ///< file name; empty for one that has just been made
  DeviationFigures deviation;
  RemovalFigures removal;
  std::size_t tips_off = 0;          ///< points whose tool tip, as the file gives it, is not that of the cutter at their contact
  PlacedValue tip_error;             ///< the farthest of them, mm
  std::vector<std::string> broken;   ///< limits that do not hold, in words
  double seconds = 0.0;              ///< of judging, with making the scan's surface where this path was the first
  std::vector<std::string> unproven; ///< limits that the scan is too noisy to show as held, in words
};

/** Reference points that the cutter leaves untouched, the rim band's too; percent of all. */
double uncutPercent(const RemovalFigures& removal);

/** The first of them. */
const PlacedValue& firstUncut(const RemovalFigures& removal);

/** The figure that a limit on the scallop holds against: the highest ridge; where none is measured, the most stock. */
const PlacedValue& highestScallop(const RemovalFigures& removal);

/** Warnings of both measurements, each once. */
std::vector<std::string> warningsOf(const Verification& verification);

/** A mesh that toolpaths were judged by. Lengths in mm. */
struct JudgedMesh {
  MeshCounts counts;
  MeshSettings settings;
  std::size_t judged_faces = 0; ///< all but of a closed mesh: those the last path touched
  double sample_spacing = 0.0;
};

/** What toolpaths were judged by. */
struct VerificationRun {
  std::string scan;                         ///< or mesh
  LengthUnit unit = LengthUnit::Millimetre; ///< of the numbers in the scan
  double tool_radius = 0.0;                 ///< mm
  double scallop_height = 0.0;              ///< mm
  double chord_error = 0.0;                 ///< mm
  std::vector<std::string> warnings;        ///< from reading
  Limits limits;
  std::optional<JudgedMesh> mesh = std::nullopt; ///< absent: by a scan
};

/** Settings, and deviation, scallop, gouge, uncut share, efficiency and motion of each path with the places of the
 *  worst. Lengths mm, angles degrees, seconds. \throw FileError */
void writeVerificationJSON(const std::string& file, const VerificationRun& run, const std::vector<Verification>& verifications);

/** The same as one HTML file that needs no other: limits held or broken, pictures, figures with their places, what the
 *  scan can show, settings, warnings, times. A section a path; \p pictures has an entry each. \throw FileError */
void writeVerificationHTML(const std::string& file, const ReportPage& page, const VerificationRun& run,
                           const std::vector<Verification>& verifications, const std::vector<std::vector<ReportPicture>>& pictures);

} // namespace pcl_spiral
