// SPDX-License-Identifier: BSD-3-Clause
#include "vocabulary.h"

#include "scan_places.h"

#include "core/given_together.h"
#include <pcl_spiral/io/program_writer.h>
#include <pcl_spiral/machine/machine_program_generator.h>
#include <pcl_spiral/planning/pass_plan.h>
#include <pcl_spiral/ridge/ridge_rows.h>
#include <pcl_spiral/spiral/spiral_settings.h>

#include <algorithm>
#include <iterator>
#include <utility>

using namespace pcl_spiral;

namespace {

/** What the library calls a setting that is in no table, or that has another name too; the option for it, and what is shown of it. */
struct SettingWords {
  const char* setting;
  const char* option;
  const char* words = nullptr; ///< null: the option
};

constexpr SettingWords settings[] = {
    {"FeedMode", "feed-mode", "--feed-mode inverse-time"},
    {"PartRegion", "region"},
    {"setClusterHandling(ClusterHandling::LeaveOut)", "clusters", "--clusters leave-out"},
    {"Dialect", "dialect"},
    {"setMachine", "machine"},
    {"setCropBox", "crop"},
    {"addKeepOut", "keep-out"},
    {"addRegion", "region"},
    {"setHolder", "holder"},
    {"setFlankLength", "flank-length"},
    {"setAcceptCollisions", "accept-collisions"},
    {"setBallClosing", "ball-closing"},
    {"setBallClosing(true)", "ball-closing"},
    {"setLargestPart(true)", "largest"},
    {"setRemedyTries", "remedy-tries"},
    {"setGougeCheck", "no-gouge-check"},
    {"setLeaveOutStrays", "leave-out-strays"},
    {"MeshSections", "mesh", "pcl_spiral_drive --mesh"},
    {"setCrop", "crop"},
    {"clearCenter", "center", "without --center"},
    {"setCutter", "tool-radius", "--tool-radius, --corner-radius, --flank-length and --flank-angle"},
    {"setInputTips", "corner-radius", "columns tip_x, tip_y, tip_z of a .csv"},
    {"setPlaneNormal", "direction"},
    {"setCeiling", "ceiling"},
    {"setMaxRetilt", "max-retilt"},
    {"setRetiltStep", "retilt-step"},
    {"setRoughPoints", "through"},
    {"setMeasuredLines", "rail"},
    {"PassSettings::cutter", "tool-radius"},
    {"RidgeRowSettings::stand_off", "stand-off"},
    {"RidgeRowSettings::step_over", "step-over"},
    {"RidgeRowSettings::overlap", "overlap"},
    {"RidgeRowSettings::tool_radius", "scallop"},
    {"RidgeRowSettings::scallop_height", "scallop"},
    {"RidgeRowSettings::spot_size", "spot", "--spot and --overlap"},
    {"RidgeRowSettings::point_spacing", "point-spacing"},
    {"RidgeRowSettings::lead", "lead"},
    {"RidgeRowSettings::tilt", "tilt"},
    {"RidgeRowSettings::run_in", "run-in"},
    {"RidgeRowSettings::run_out", "run-out"},
    {"RidgeSettings::measuring_error", "measuring-error"},
    {"RidgeSettings::reference", "reference"},
    {"RidgeSettings::flip", "flip-normals"},
    {"PassSettings::holder", "holder"},
    {"PassSettings::accept_collisions", "accept-collisions"},
    {"setHalfWidth", "half-width"},
    {"setClosed", "ring"},
    {"setSpot", "spot", "--spot and --overlap"},
    {"DriveCylinder::axis", "column-axis"},
    {"setInputMesh", "mesh"},
    {"setCylinder", "column-axis", "--column-axis and --column-centre"},
    {"MaterialRemoval", "verify"},
    {"OutlierRemoval", "leave-out-strays"},
    {"setSampleSpacing", "sample-spacing"},
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
};

bool
hasOption(const std::string& name)
{
  static const std::vector<std::string> own = ownOptions();
  return std::find(own.begin(), own.end(), name) != own.end();
}

/** The options for the settings of a table. */
template <typename Settings>
void
addTable(Settings settings, Vocabulary& vocabulary)
{
  for (const Setting& setting : settingTable(settings))
    if (!setting.option.empty() && hasOption(setting.option))
      vocabulary.words[setting.setter] = "--" + setting.option;
}

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
    {"scan what is between them", "join them in the mesh"},
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
  addTable(SpiralSettings(), vocabulary);
  addTable(DriveSettings(), vocabulary);
  addTable(PassSettings(), vocabulary);
  addTable(MeshSettings(), vocabulary);
  addTable(RidgeSettings(), vocabulary);
  addTable(RidgeRowSettings(), vocabulary);
  addTable(ProgramSettings(), vocabulary);
  addTable(ProgramHeader(), vocabulary);
  for (const SettingWords& s : settings)
    if (hasOption(s.option))
      vocabulary.words[s.setting] = s.words != nullptr ? s.words : std::string("--") + s.option;
  if (hasOption("units"))
    vocabulary.words["Scale it to mm"] = "Give its unit (--units m), or scale it to mm";
  if (of_mesh)
    vocabulary.words.insert(std::begin(mesh_words), std::end(mesh_words));
  vocabulary.words[between_settings] = " ";
  vocabulary.place = shownPlace;
  vocabulary.given = optionValue;
  return vocabulary;
}

std::string
inWords(const Diagnostic& diagnostic)
{
  return diagnostic.text(programWords());
}
