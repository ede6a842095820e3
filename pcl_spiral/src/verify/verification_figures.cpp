// SPDX-License-Identifier: BSD-3-Clause
#include "verify/verification_figures.h"

#include <cmath>

namespace pcl_spiral {
namespace {

constexpr FigureStyle height{FigureUnit::Millimetre, ".4f", false}, both_ways{FigureUnit::Millimetre, ".4f", true},
    sigma{FigureUnit::Millimetre, ".2g", false}, band{FigureUnit::Millimetre, ".3g", false}, step{FigureUnit::Millimetre, ".4g", false},
    metres{FigureUnit::Metre, ".3f", false}, angle{FigureUnit::Degree, ".3g", false}, percent{FigureUnit::Percent, ".3g", false},
    share{FigureUnit::Share, ".3g", false}, ratio{FigureUnit::None, ".3f", false};

void
addReference(FigureTable& table, const DeviationReport& d)
{
  table.number("noise", d.noise, sigma);
  table.number("fit_noise", d.fit_noise, sigma);
  table.count("reference/points", d.reference_points).knownIf(!d.by_mesh).forPeople();
  table.count("reference/samples", d.reference_points).knownIf(d.by_mesh).forPeople();
}

void
addContacts(FigureTable& table, const DeviationReport& d, const Limits& limits)
{
  table.number("deviation/rms", d.rms, height).named("Deviation, rms");
  table.number("deviation/p99", d.p99, height).named("Deviation, amount: 99 % below");
  table.placed("deviation/max", d.max, both_ways)
      .named("Deviation of contacts from the surface, largest (+ out of the material)")
      .limited("{Limits::deviation}", limits.deviation, std::abs(d.max.value), "", true);
  table.placed("deviation/beyond_rim_max", d.rim_max, both_ways)
      .knownIf(d.beyond_rim > 0)
      .named("Deviation beyond the outermost scan points, largest of {deviation/beyond_rim} contacts")
      .limited("{Limits::deviation}", limits.deviation, std::abs(d.rim_max.value), " beyond the rim");
  table.placed("deviation/gap_max", d.gap_max, both_ways)
      .knownIf(d.in_gaps > 0)
      .named("Distance of {deviation/in_gaps} contacts in gaps of the scan from the extrapolated surface, largest");
  table.placed("deviation/crease_max", d.crease_max, both_ways)
      .knownIf(d.in_crease_band > 0)
      .named("Within {deviation/crease_band} of creases, where fits round them: {deviation/in_crease_band} contacts, largest distance "
             "from the fit; no verdict");
  table.placed("deviation/lift_max", d.lift_max, height)
      .knownIf(d.lifted > 0)
      .named("Lift of {deviation/lifted} contacts off places that the ball does not reach, largest; no verdict");
  table.number("deviation/turn_wobble_rms", d.wobble.rms, height)
      .knownIf(d.wobble.measured > 0)
      .named("Wobble from turn to turn (deviation minus the mean of the two neighbouring turns), rms");
  table.placed("deviation/turn_wobble_max", d.wobble.max, both_ways)
      .knownIf(d.wobble.measured > 0)
      .named("Wobble from turn to turn, largest");
}

void
addDeviation(FigureTable& table, const DeviationReport& d, const Limits& limits)
{
  table.count("deviation/points", d.points);
  table.count("deviation/measured", d.measured);
  table.count("deviation/beyond_rim", d.beyond_rim);
  table.count("deviation/in_gaps", d.in_gaps);
  table.count("deviation/in_crease_band", d.in_crease_band);
  table.count("deviation/lifted", d.lifted);
  table.number("deviation/crease_band", d.crease_band, band);
  table.count("deviation/unmeasured", d.unmeasured)
      .named("Contacts off the surface, not measured", "{deviation/unmeasured} of {deviation/points}");
  addContacts(table, d, limits);
  table.number("deviation/normal_p99", d.normal_p99, angle).named("Normal error, 99 % below");
  table.placed("deviation/normal_max", d.normal_error, angle).named("Normal error, largest");
  table.count("deviation/opposed_normals", d.opposed).named("Normals that point into the material").first(d.first_opposed);
  table.count("deviation/inward_axes", d.inward_axes).named("Tool axes that point into the material").first(d.first_inward);
  table.number("deviation/seconds", d.seconds, {});
}

void
addStock(FigureTable& table, const std::string& key, const StockReport& s)
{
  const bool any = s.samples > 0;
  table.count(key + "/samples", s.samples);
  table.number(key + "/p50", s.p50, height).knownIf(any);
  table.number(key + "/p90", s.p90, height).knownIf(any);
  table.number(key + "/p99", s.p99, height).knownIf(any);
  table.number(key + "/p99.9", s.p999, height).knownIf(any);
  table.placed(key + "/max", s.max, height).knownIf(any);
  table.number(key + "/uncut_share", s.uncutShare(), share).knownIf(any);
  table.placed(key + "/first_uncut", s.uncut > 0 ? std::optional(s.first_uncut) : std::nullopt, height);
  table.number(key + "/share_above_limit", s.share_above, share).knownIf(any);
}

/** The stock in all bands. */
void
addBands(FigureTable& table, const RemovalReport& r, const Limits& limits)
{
  addStock(table, "material/scallop", r.scallop);
  table.at("material/scallop/p50").named("Scallop: ridge between passes, median");
  table.at("material/scallop/p99").named("Scallop, 99 % below");
  table.at("material/scallop/p99.9").named("Scallop, 99.9 % below");
  table.at("material/scallop/share_above_limit").named("Ridges above 1.02 h + e = {material/scallop_limit}");
  const PlacedValue& highest = highestScallop(r);
  table.placed("material/highest", highest, height)
      .forPeople()
      .named(r.scallop.samples > 0 ? "Scallop, highest" : "Stock left, highest (no ridge was measured)")
      .limited("{Limits::scallop}", limits.scallop, highest.value, "", true);
  addStock(table, "material/stock", r.stock);
  addStock(table, "material/rim_band", r.rim);
  table.at("material/rim_band/max")
      .named("Stock within one step-over of the rim, highest")
      .limited("{Limits::scallop}", limits.scallop, r.rim.max.value, " left at the rim");
  addStock(table, "material/unreached", r.unreached);
  table.at("material/unreached/max").named("Stock where the ball does not reach, highest; no verdict");
  table.number("material/fitting_radius", r.fitting_radius, step)
      .named("Radius of the largest ball that reaches everything, at most the tool's");
  addStock(table, "material/crease_band", r.crease);
  table.at("material/crease_band/max").named("Stock within {deviation/crease_band} of creases, highest; no verdict");
}

void
addGouges(FigureTable& table, const RemovalReport& r, const Limits& limits)
{
  table.placed("material/crease_gouge", r.crease_gouge, height).knownIf(r.crease.samples > 0).named("Gouge there, deepest; no verdict");
  table.placed("material/gouge", r.gouge, height)
      .knownIf(r.gouge.value > 0.0, "none")
      .named(r.gouge.value > 0.0 ? "Gouge, deepest" : "Gouge")
      .limited("{Limits::gouge}", limits.gouge, r.gouge.value, "", true);
  table.placed("material/rim_gouge", r.rim_gouge, height)
      .knownIf(r.rim_gouge.value > 0.0)
      .named("Gouge at the rim, just outside the outermost scan points, deepest")
      .limited("{Limits::gouge}", limits.gouge, r.rim_gouge.value, " beyond the rim");
  table.placed("material/face_depth", r.face_depth, height)
      .knownIf(r.face_depth.value > 0.0)
      .named("Depth below the flat faces of the mesh, deepest; no verdict");
  table.placed("material/face_gouge", r.face_gouge, height)
      .knownIf(r.face_gouge.value > 0.0)
      .named("Gouge into the flat faces: depth that the bends between them do not explain")
      .limited("{Limits::gouge}", limits.gouge, r.face_gouge.value, " into the flat faces of the mesh");
}

void
addMaterial(FigureTable& table, const RemovalReport& r, const Limits& limits)
{
  table.count("material/reference_points", r.reference_points);
  table.count("material/unmeasured", r.unmeasured);
  table.number("material/scallop_limit", r.limit, step);
  table.number("material/reach", r.reach, height);
  addBands(table, r, limits);
  addGouges(table, r, limits);
  const double uncut = uncutPercent(r);
  Figure& uncut_points = table.number("material/uncut", uncut, percent);
  uncut_points.forPeople().named("Uncut points").limited("{Limits::uncut}", limits.uncut, uncut);
  if (uncut > 0.0)
    uncut_points.first(firstUncut(r));
  table.number("material/area", r.area, {});
  table.number("material/rim_length", r.rim_length, metres);
  table.number("material/least_length", r.least_length, metres).named("Least length of a path that cuts the same to this scallop height");
  table.number("material/path_length", r.path_length, metres).forPeople();
  table.number("material/efficiency", r.efficiency, ratio)
      .named("Efficiency \u03b7 of what is cut to the scallop height: least length / path length");
  table.number("material/seconds", r.seconds, {});
}

void
addMotion(FigureTable& table, const PathMotion& m)
{
  table.number("motion/length", m.length, metres).named("Path length");
  table.count("motion/lifts", m.lifts).named("Lifts between passes, no cuts", "{motion/lifts}, {motion/lift_length}");
  table.number("motion/lift_length", m.lift_length, metres);
  table.placed("motion/largest_gap", m.gap, step).named("Longest linear move (largest gap)");
  table.placed("motion/largest_turn", m.turn, angle).named("Largest turn per step");
  table.placed("motion/largest_axis_change", m.axis_change, angle).named("Largest change of the axis in one move");
  table.placed("motion/largest_normal_change", m.normal_change, angle);
}

/** Zero for a path that is no program. */
void
addProgram(FigureTable& table, const std::optional<ProgramFileReport>& program)
{
  const ProgramFileReport p = program.value_or(ProgramFileReport());
  const auto count = [&](const char* key, std::size_t value, const char* name) {
    Figure& figure = table.count(key, value).knownIf(program.has_value()).named(name);
    if (!program)
      figure.forPeople();
  };
  count("program/blocks", p.blocks, "Moves of the program");
  count("program/passes", p.passes, "Passes that cut");
  count("program/other_moves", p.leads.moves, "Moves that do not cut");
  count("program/colliding_moves", p.leads.collided, "Moves that do not cut, but collide with the scan");
}

} // namespace

FigureTable
figuresOf(const Verification& verification, const Limits& limits)
{
  FigureTable table;
  addReference(table, verification.deviation);
  addDeviation(table, verification.deviation, limits);
  addMaterial(table, verification.removal, limits);
  addMotion(table, verification.deviation.motion);
  table.count("tips_off", verification.tips_off);
  table.placed("tip_error", verification.tip_error, height);
  addProgram(table, verification.program);
  if (verification.program)
    table.placeByLine(verification.program->lines);
  return table;
}

} // namespace pcl_spiral
