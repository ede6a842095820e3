// SPDX-License-Identifier: BSD-3-Clause
#include "vocabulary.h"

#include "scan_places.h"

#include <iterator>
#include <utility>

using namespace pcl_spiral;

namespace {

/** What the library calls a setting, the option for it, and what is shown of it. */
struct SettingWords {
  const char* setting;
  const char* option;
  const char* words = nullptr; ///< null: the option
};

constexpr SettingWords settings[] = {
    {"FeedMode", "feed-mode", "--feed-mode inverse-time"},
    {"setFixedAxis", "axis"},
    {"setTiltAngle", "tilt"},
    {"setLeadAngle", "lead"},
    {"setThinning", "thin"},
    {"setLargestPart", "largest"},
    {"setPartAt", "part-at"},
    {"PartRegion", "region"},
    {"setClusterHandling", "clusters"},
    {"setClusterHandling(ClusterHandling::LeaveOut)", "clusters", "--clusters leave-out"},
    {"setCropBox", "crop"},
    {"addKeepOut", "keep-out"},
    {"addRegion", "region"},
    {"setHolder", "holder"},
    {"setFlankLength", "flank-length"},
    {"setAcceptCollisions", "accept-collisions"},
    {"ProgramSettings::pole_cone", "pole-cone"},
    {"setGougeCheck", "no-gouge-check"},
    {"setOverrun", "overrun"},
    {"setKind", "drive"},
    {"MeshSettings::crease_angle", "crease-angle"},
    {"ProgramSettings::lead", "lead-in"},
    {"ProgramSettings::stay_down", "stay-down"},
    {"ProgramSettings::lead_length", "lead-length"},
    {"setLeaveOutStrays", "leave-out-strays"},
    {"PassSettings::max_retilt", "max-retilt"},
    {"PassSettings::ceiling", "ceiling"},
    {"MeshSections", "mesh", "pcl_spiral_drive --mesh"},
    {"setCrop", "crop"},
    {"setViewPoint", "view-point"},
    {"setFlipNormals", "flip-normals"},
    {"setOutlierRemoval", "outliers"},
    {"setGapHandling", "gaps"},
    {"setTightHandling", "tight"},
    {"setBoundaryMode", "boundaries"},
    {"setLineMethod", "lines"},
    {"setCenter", "center"},
    {"clearCenter", "center", "without --center"},
    {"setMethod", "method"},
    {"setPitch", "pitch"},
    {"setSense", "sense"},
    {"setStartPoint", "start"},
    {"setMaxStep", "max-step"},
    {"setHoleHandling", "holes"},
    {"setHoleSize", "hole-size"},
    {"setOneWay", "one-way"},
    {"setHoleMargin", "hole-margin"},
    {"setRimOverhang", "rim"},
    {"setLeastTurnRadius", "turn-radius"},
    {"setToolRadius", "tool-radius"},
    {"setCutter", "tool-radius", "--tool-radius, --corner-radius, --flank-length and --flank-angle"},
    {"setInputTips", "corner-radius", "columns tip_x, tip_y, tip_z of a .csv"},
    {"setScallopHeight", "scallop"},
    {"setScallop", "scallop"},
    {"setPlaneDirection", "direction"},
    {"setPlaneNormal", "direction"},
    {"setStepOver", "step-over"},
    {"setPointSpacing", "point-spacing"},
    {"setAxis", "axis"},
    {"setAxisMode", "axis-mode"},
    {"setAxisSmoothing", "axis-smoothing"},
    {"setMaxAxisRate", "max-axis-rate"},
    {"setRows", "rows"},
    {"setCeiling", "ceiling"},
    {"setMaxRetilt", "max-retilt"},
    {"setRetiltStep", "retilt-step"},
    {"setChordError", "chord-error"},
    {"setReferenceNormal", "reference"},
    {"setMeasuringError", "measuring-error"},
    {"setRoughPoints", "through"},
    {"setHalfWidth", "half-width"},
    {"setClosed", "ring"},
    {"setSpot", "spot", "--spot and --overlap"},
    {"setStandOff", "stand-off"},
    {"setLead", "lead"},
    {"setTilt", "tilt"},
    {"setCylinder", "column-axis", "--column-axis and --column-centre"},
    {"MaterialRemoval", "verify"},
    {"StrayRemoval", "leave-out-strays"},
    {"setSampleSpacing", "sample-spacing"},
    {"setCreaseAngle", "crease-angle"},
    {"setNumberOfThreads", "threads"},
    {"Limits::gouge", "max-gouge"},
    {"Limits::scallop", "max-scallop"},
    {"Limits::deviation", "max-deviation"},
    {"Limits::uncut", "max-uncut"},
    {"ReadOptions::columns", "columns"},
    {"ReadOptions::skip_lines", "skip-lines"},
    {"ReadOptions::origin", "origin", "--origin X,Y,Z"},
    {"ReadOptions::unit", "units", "--units m, --units ft, --units us-ft, --units inch"},
    {"ReadOptions::find_origin", "origin", "without --origin"},
    {"setSpacing", "sample-spacing"},
    {"readCloud", "mesh", "leave --mesh out"},
    {"setClusterHandling(ClusterHandling::Ride)", "clusters", "--clusters ride"},
    {"BallReach", "reach", "--reach FILE"},
    {"setTightHandling(TightHandling::Refuse)", "tight", "--tight refuse"},
    {"MeshSettings::flip", "flip-normals"},
};

bool of_mesh = false;

/** What is said of a scan, and what is said of a mesh instead. */
constexpr std::pair<const char*, const char*> mesh_words[] = {
    {"scan", "mesh"},
    {"cloud", "mesh"},
    {"on the scan", "on the mesh; if that place is only roughness of the mesh, increase the sample spacing (--sample-spacing)"},
    {"scanned surface", "surface"},
    {"a gap in the scan", "a hole of the mesh"},
    {"gaps of the scan", "holes of the mesh"},
    {"if it is a real hole, the path still runs over it", "it is narrower than the holes asked for (--hole-size)"},
    {"scan it again", "close it in the mesh"},
    {"scan it again, more densely", "sample it more closely (--sample-spacing)"},
    {"scan more densely", "sample it more closely (--sample-spacing)"},
    {"is below the noise of the scan", "is below what local fits to the samples of the mesh leave"},
    {"standard deviation of a point", "standard deviation"},
    {"this scan cannot show whether it was kept", "sample it more closely (--sample-spacing)"}};

} // namespace

void
speakOfMesh()
{
  of_mesh = true;
}

Vocabulary
programWords()
{
  Vocabulary vocabulary;
  vocabulary.has_setters = false;
  for (const SettingWords& s : settings)
    if (hasOption(s.option))
      vocabulary.words[s.setting] = s.words != nullptr ? s.words : std::string("--") + s.option;
  if (hasOption("units"))
    vocabulary.words["Scale it to mm"] = "Give its unit (--units m), or scale it to mm";
  if (of_mesh)
    vocabulary.words.insert(std::begin(mesh_words), std::end(mesh_words));
  vocabulary.place = shownPlace;
  return vocabulary;
}

std::string
inWords(const Diagnostic& diagnostic)
{
  return diagnostic.text(programWords());
}
