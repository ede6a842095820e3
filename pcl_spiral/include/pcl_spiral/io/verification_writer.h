// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Figures of judged toolpaths, as JSON and as an HTML page.
 */
#pragma once

#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/io/report_page.h>
#include <pcl_spiral/mesh/surface_mesh.h>
#include <pcl_spiral/verify/verification.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl_spiral {

/** A mesh that toolpaths were judged by. Lengths in mm. */
struct JudgedMesh {
  MeshReport counts;            ///< of the file
  MeshSettings settings;        ///< by which it was read
  std::size_t judged_faces = 0; ///< all; of a closed mesh only those that the last path touched
  double sample_spacing = 0.0;  ///< distance of the samples
};

/** What toolpaths were judged by. */
struct VerificationRun {
  std::string scan;                                ///< or mesh
  LengthUnit unit = LengthUnit::Millimetre;        ///< of the numbers in the scan
  CutterShape cutter;                              ///< that was swept
  double scallop_height = 0.0;                     ///< mm
  double chord_error = 0.0;                        ///< mm
  Diagnostics warnings;                            ///< from reading
  Limits limits;                                   ///< that the paths had to keep
  std::optional<JudgedMesh> mesh = std::nullopt;   ///< absent: a scan
  Eigen::Vector3d shift = Eigen::Vector3d::Zero(); ///< of map coordinates, mm, see Scan::shift: added to all places
  Vocabulary words = {};                           ///< of what the verifications say
  std::shared_ptr<const ReportScene> scene = {};   ///< of the first path, in 3-D; null: pictures alone
};

/** Settings, and the figures of each path with their places; Verification::path and Verification::region name it, set them first.
 *  \code
 *  Verification found;
 *  verifier.compute(found); // a PathVerifier
 *  found.path = "part.csv";
 *  VerificationRun run;
 *  run.scan = "part.pcd";
 *  run.cutter = verifier.getCutter();
 *  run.scallop_height = verifier.getScallopHeight();
 *  run.chord_error = verifier.getChordError();
 *  run.limits = verifier.getLimits();
 *  writeVerificationJSON("verified.json", run, {found});
 *  \endcode
 * Lengths in mm, angles in degrees, times in
 *  seconds. \throw FileError */
void writeVerificationJSON(const std::string& file, const VerificationRun& run, const std::vector<Verification>& verifications);
/** The same as a text. */
std::string verificationsJSON(const VerificationRun& run, const std::vector<Verification>& verifications);

/** The same as one HTML file that needs no other: limits held or broken, pictures, figures with their places, what the
 *  scan can show, settings, warnings, times. One section for each path; \p pictures has an entry for each. \throw FileError */
void writeVerificationHTML(const std::string& file, const ReportPage& page, const VerificationRun& run,
                           const std::vector<Verification>& verifications, const std::vector<std::vector<ReportPicture>>& pictures);

} // namespace pcl_spiral
