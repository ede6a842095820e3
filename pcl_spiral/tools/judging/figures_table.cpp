// SPDX-License-Identifier: BSD-3-Clause
#include "figures_table.h"

#include "terminal/vocabulary.h"
#include "verify/figure_text.h"
#include "verify/verification_figures.h"

#include <pcl_spiral/io/motion_text.h>

#include <cstdio>

using namespace pcl_spiral;

namespace {

/** A line of the table; see filled(). */
struct Line {
  const char* label;
  const char* text;
  const char* if_none = nullptr; ///< stands for the text if one of its figures is not known; null: there is no line
};

constexpr const char* no_stock = "no reference point lies there";
constexpr const char* high_ridges = "{material/scallop/share_above_limit} of the ridges above {material/scallop_limit}";

constexpr Line lines[] = {
    {"reference", "{reference/samples} samples of the mesh; their surface is known to {fit_noise}"},
    {"reference", "{reference/points} points, noise {noise}; its surface is known to {fit_noise}"},
    {"deviation", "rms {#deviation/rms}, p99 {#deviation/p99}, max {deviation/max}{@deviation/max}"},
    {"turn to turn", "wobble rms {#deviation/turn_wobble_rms}, max {deviation/turn_wobble_max}{@deviation/turn_wobble_max}"},
    {"beyond the rim", "{deviation/beyond_rim} points, max {deviation/beyond_rim_max}{@deviation/beyond_rim_max}"},
    {"in scan gaps", "{deviation/in_gaps} points, {deviation/gap_max} from the extrapolated surface{@deviation/gap_max}"},
    {"at creases", "{deviation/in_crease_band} points within {deviation/crease_band}, up to {deviation/crease_max} off the rounded "
                   "fit{@deviation/crease_max}"},
    {"", "stock up to {material/crease_band/max}{@material/crease_band/max}, gouge {material/crease_gouge}; no verdict"},
    {"not reached", "stock up to {material/unreached/max}{@material/unreached/max}; a ball of radius {material/fitting_radius} reaches "
                    "everything; no verdict"},
    {"lifted there", "{deviation/lifted} points, by up to {deviation/lift_max}{@deviation/lift_max}"},
    {"off the surface", "{deviation/unmeasured} points"},
    {"normals", "p99 {#deviation/normal_p99}, max {deviation/normal_max}{@deviation/normal_max}"},
    {"turned normals", "{deviation/opposed_normals}{@deviation/opposed_normals}"},
    {"inward axes", "{deviation/inward_axes}{@deviation/inward_axes}"},
    {"wrong tips", "{tips_off}, by up to {tip_error}{@tip_error}"},
    {"scallop",
     "p50 {#material/scallop/p50}, p99 {#material/scallop/p99}, p99.9 {#material/scallop/p99.9}, max "
     "{material/scallop/max}{@material/scallop/max}",
     no_stock},
    {"", high_ridges, high_ridges},
    {"stock at rim",
     "p50 {#material/rim_band/p50}, p99 {#material/rim_band/p99}, p99.9 {#material/rim_band/p99.9}, max "
     "{material/rim_band/max}{@material/rim_band/max}",
     no_stock},
    {"gouge", "{material/gouge}{@material/gouge}", "none"},
    {"  beyond the rim", " {material/rim_gouge}{@material/rim_gouge}"},
    {"below the faces", "{material/face_depth}{@material/face_depth}, no verdict"},
    {"  unexplained", " {material/face_gouge}{@material/face_gouge}: more than the bends between the faces explain"},
    {"uncut", "{material/uncut} of the points{@material/uncut}"},
    {"efficiency",
     "{material/efficiency}: least length for what is cut to the scallop height {material/least_length}, of {material/path_length}"},
    {"lifts", "{motion/lifts} between passes, {motion/lift_length}, no cuts"},
    {"largest step", "{motion/largest_gap}{@motion/largest_gap}"},
    {"largest turn", "{motion/largest_turn} a step{@motion/largest_turn}"},
    {"program",
     "{program/blocks} moves, {program/passes} passes, {program/other_moves} moves do not cut, {program/colliding_moves} of these collide"},
    {"axis change", "{motion/largest_axis_change} a step{@motion/largest_axis_change}"},
};

void
print(const char* label, const std::string& text)
{
  std::printf("%-16s%s\n", label, text.c_str());
}

} // namespace

void
printFigures(const Verification& verification)
{
  const FigureTable table = figuresOf(verification);
  if (!verification.path.empty())
    print("path", nameOf(verification) + filled(": {deviation/points} points, {motion/length}", table));
  for (const Line& line : lines) {
    const char* const text = allKnown(line.text, table) ? line.text : line.if_none;
    if (text)
      print(line.label, filled(text, table));
  }
  if (verification.program && verification.program->motion && verification.program->motion->status.ok()) {
    print("on the control", motionText(*verification.program->motion));
    print("would gain most", gainText(*verification.program->motion));
  }
  for (const Diagnostic& broken : verification.broken)
    print("LIMIT", inWords(broken));
  for (const Diagnostic& unproven : verification.unproven)
    print("limit", inWords(unproven));
}
