// SPDX-License-Identifier: BSD-3-Clause
// Rows over a ridge that are refused or warned of: each remedy that the message names helps.
#include "support/plate_scans.h"
#include "support/remedies.h"
#include "support/ridge_scans.h"
#include "support/sampling.h"

#include <pcl_spiral/planning/ridge_planner.h>

#include <gtest/gtest.h>

namespace ridge_remedies_test {
namespace {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;
using Ridge = RidgePlanner<pcl::PointXYZ>;
using Change = test::Change<Ridge>;
using Remedies = std::vector<Remedy<Ridge>>;

constexpr double radius = 6.0; // mm, of the ball

Said
say(Ridge& planner)
{
  planner.compute();
  return {planner.getStatus(), planner.getPlan().warnings};
}

/** A straight ridge, 60 mm long: a parabola across x, and a hollow if \p height is below 0. */
ExactRidge
ridge(double height)
{
  return {[](double t) { return Vector3d(60.0 * t, 0.0, 0.0); },
          [height](double w) { return Vector3d(0.0, 30.0 * w, 4.0 * height * w * (1.0 - w)); }};
}

void
giveLines(Ridge& planner)
{
  planner.setMeasuredLines(ridge(10.0).railPoints(60), ridge(10.0).generatorPoints(0.37, 40));
}

void
takeLines(Ridge& planner)
{
  planner.setMeasuredLines({}, {});
}

template <typename Member, typename Value>
Change
row(Member RidgeRowSettings::*member, Value value)
{
  return [=](Ridge& r) {
    RidgeRowSettings settings = r.getRowSettings();
    settings.*member = value;
    r.setRowSettings(settings);
  };
}

template <typename Member, typename Value>
Change
side(Member RidgeSettings::*member, const Value& value)
{
  return [=](Ridge& r) {
    RidgeSettings settings = r.getRidgeSettings();
    settings.*member = value;
    r.setRidgeSettings(settings);
  };
}

template <typename Member, typename Value>
Change
tool(Member PassSettings::*member, const Value& value)
{
  return [=](Ridge& r) {
    PassSettings settings = r.getPassSettings();
    settings.*member = value;
    r.setPassSettings(settings);
  };
}

const auto ball = tool(&PassSettings::cutter, CutterShape::ball(radius));
const auto beam = tool(&PassSettings::cutter, CutterShape());
const auto no_scan = [](Ridge& r) { r.setInputCloud(nullptr); };
const auto no_width = [](Ridge& r) { r.setHalfWidth(0.0); };

/** Rows of a beam over measured lines, with \p change. */
RemediedJob
rows(const char* words, const Change& change, const Remedies& remedies)
{
  const Change prepare = [change](Ridge& planner) {
    giveLines(planner);
    row(&RidgeRowSettings::step_over, 4.0)(planner);
    row(&RidgeRowSettings::point_spacing, 3.0)(planner);
    change(planner);
  };
  return remediedJob<Ridge>(words, say, prepare, remedies);
}

void
giveScan(Ridge& planner, double height)
{
  planner.setInputCloud(toCloud(scanOf(ridge(height), 60, 30, 0.005, 1)));
}

/** Leaves points of the scan with y below \p most. */
void
onlyBelow(double most, Ridge& planner)
{
  const auto some = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const pcl::PointXYZ& p : *planner.getInputCloud())
    if (p.y < most)
      some->push_back(p);
  planner.setInputCloud(some);
}

/** Adds a flat sheet beside the ridge. */
void
besideFlat(Ridge& planner)
{
  const auto more = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>(*planner.getInputCloud());
  addSheet(
      30.0, 15.0, 1.0, [](double u, double v) { return Vector3d(u + 30.0, v + 45.0, 0.0); }, *more);
  planner.setInputCloud(more);
}

const auto rough = [](Ridge& r) { r.setRoughPoints({Vector3d(8.0, 15.0, 10.0), Vector3d(52.0, 14.0, 10.0)}); };

/** The same over a ridge in a scan, \p height high. */
RemediedJob
inScan(const char* words, double height, const Change& change, const Remedies& remedies)
{
  const Change in_scan = [height, change](Ridge& planner) {
    takeLines(planner);
    giveScan(planner, height);
    rough(planner);
    planner.setHalfWidth(9.0);
    change(planner);
  };
  return rows(words, in_scan, remedies);
}

} // namespace

TEST(RidgeRemedies, Rows)
{
  using S = RidgeRowSettings;
  const auto undecided = [](Ridge& r) { row(&S::step_over, 0.0)(r); };
  const auto scallop = [](Ridge& r) { row(&S::step_over, 0.0)(r), row(&S::tool_radius, radius)(r), row(&S::scallop_height, 0.05)(r); };
  const auto spot = row(&S::spot_size, 4.0);
  const auto step = row(&S::step_over, 4.0);
  expectNoFaults({
      rows("no setting defines", undecided,
           {{"RidgeRowSettings::step_over", step},
            {"RidgeRowSettings::spot_size", spot},
            {"RidgeRowSettings::tool_radius", scallop},
            {"RidgeRowSettings::scallop_height", scallop}}),
      rows("the scallop height is ", [&](Ridge& r) { scallop(r), row(&S::scallop_height, 9.0)(r); },
           {{"RidgeRowSettings::scallop_height", scallop}}),
      rows("the spacing of points is ", row(&S::point_spacing, 0.0), {{"RidgeRowSettings::point_spacing", row(&S::point_spacing, 1.0)}}),
      rows("the tilt angle is ", row(&S::tilt, 90.0), {{"RidgeRowSettings::tilt", row(&S::tilt, 5.0)}}),
      rows("the rows would have more than", row(&S::point_spacing, 1e-5),
           {{"RidgeRowSettings::point_spacing", row(&S::point_spacing, 1.0)}}),
      rows("the rows would have more than", [](Ridge& r) { row(&S::point_spacing, 0.003)(r), row(&S::step_over, 2e-3)(r); },
           {{"RidgeRowSettings::step_over", step}}),
      rows("an overlap belongs to the spot", row(&S::overlap, 0.2), {{"RidgeRowSettings::overlap", row(&S::overlap, 0.0)}}),
      rows("a cutter touches the surface", [](Ridge& r) { ball(r), row(&S::stand_off, 2.0)(r); },
           {{"RidgeRowSettings::stand_off", row(&S::stand_off, 0.0)}, {"PassSettings::cutter", beam}}),
      rows("a spot belongs to a beam", [&](Ridge& r) { ball(r), row(&S::step_over, 0.0)(r), spot(r); },
           {{"RidgeRowSettings::step_over", [&](Ridge& r) { row(&S::spot_size, 0.0)(r), step(r); }}}),
      rows("and the cutter is another one", [&](Ridge& r) { scallop(r), tool(&PassSettings::cutter, CutterShape::ball(4.0))(r); },
           {{"RidgeRowSettings::tool_radius", row(&S::tool_radius, 4.0)},
            {"RidgeRowSettings::step_over", [&](Ridge& r) { row(&S::tool_radius, 0.0)(r), row(&S::scallop_height, 0.0)(r), step(r); }}}),
      rows("the cutter ({PassSettings::cutter}): ", tool(&PassSettings::cutter, CutterShape::ball(-1.0)), {{"PassSettings::cutter", ball}}),
      rows("belong to a cutter", tool(&PassSettings::max_retilt, 9.0), {{"PassSettings::cutter", ball}}),
      rows("the tolerance is ", [](Ridge& r) { ball(r), tool(&PassSettings::tolerance, 0.0)(r); },
           {{"PassSettings::tolerance", tool(&PassSettings::tolerance, 0.01)}}),
  });
}

TEST(RidgeRemedies, Input)
{
  const auto both = [](Ridge& r) { giveLines(r), no_scan(r), no_width(r), r.setRoughPoints({}); };
  const auto scan = [](Ridge& r) { takeLines(r), giveScan(r, 10.0), rough(r), r.setHalfWidth(9.0); };
  expectNoFaults({
      rows("the lines of the ridge are missing", takeLines,
           {{"setMeasuredLines", giveLines}, {"setInputCloud", scan}, {"setRoughPoints", scan}}),
      inScan("are both given", 10.0, giveLines, {{"setMeasuredLines", takeLines}, {"setRoughPoints", both}}),
      inScan("are given, but no scan", 10.0, no_scan, {{"setRoughPoints", both}, {"setInputCloud", scan}}),
      rows("half width and ring", [](Ridge& r) { r.setHalfWidth(9.0); }, {{"setHalfWidth", no_width}}),
      rows("half width and ring", [](Ridge& r) { r.setClosed(true); }, {{"setClosed", [](Ridge& r) { r.setClosed(false); }}}),
      inScan("and so is the noise", 10.0, side(&RidgeSettings::measuring_error, 0.1),
             {{"RidgeSettings::measuring_error", side(&RidgeSettings::measuring_error, 0.0)}}),
      rows("settings of a scan are given", [](Ridge& r) { r.setThinning(0.5); },
           {{"setThinning", [](Ridge& r) { r.setThinning(0.0); }}, {"setInputCloud", scan}}),
      rows("settings of a scan are given", [](Ridge& r) { r.setLeaveOutStrays(true); },
           {{"setLeaveOutStrays", [](Ridge& r) { r.setLeaveOutStrays(false); }}}),
      rows("settings of a scan are given", [](Ridge& r) { r.setLargestPart(true); },
           {{"setLargestPart", [](Ridge& r) { r.setLargestPart(false); }}}),
      rows("a beam uses only the measured lines", [](Ridge& r) { giveScan(r, 10.0); },
           {{"setInputCloud", no_scan}, {"PassSettings::cutter", ball}, {"setRoughPoints", scan}}),
  });
}

TEST(RidgeRemedies, TheRidgeInTheScan)
{
  const auto through = [](const Polyline& points) { return [points](Ridge& r) { r.setRoughPoints(points); }; };
  const auto width = [](double width) { return [width](Ridge& r) { r.setHalfWidth(width); }; };
  const Vector3d up = Vector3d::UnitZ();
  expectNoFaults({
      inScan("rough points; ", 10.0, through({up}), {{"setRoughPoints", rough}}),
      inScan("is not finite: remove it", 10.0, through({up, Vector3d::Constant(NAN)}), {{"setRoughPoints", rough}}),
      inScan("are both at", 10.0, through({up, up}), {{"setRoughPoints", rough}}),
      inScan("{mm} away from the scan", 10.0, through({{8.0, 15.0, 90.0}, {52.0, 14.0, 10.0}}), {{"setRoughPoints", rough}}),
      inScan("the half width is ", 10.0, width(0.0), {{"setHalfWidth", width(9.0)}}),
      inScan("the reference normal has no direction", 10.0, side(&RidgeSettings::reference, Vector3d(Vector3d::Zero())),
             {{"RidgeSettings::reference", side(&RidgeSettings::reference, up)}}),
      inScan("is too steep at", 10.0, side(&RidgeSettings::reference, Vector3d(Vector3d::UnitX())),
             {{"RidgeSettings::reference", side(&RidgeSettings::reference, up)}}),
      inScan("the band of the ridge leaves the scan", 10.0, [&](Ridge& r) { onlyBelow(13.5, r), width(12.0)(r); },
             {{"setHalfWidth", width(3.0)}}),
      inScan("there is no crest between", -10.0, through({{8.0, 15.0, -10.0}, {52.0, 14.0, -10.0}}),
             {{"RidgeSettings::flip", side(&RidgeSettings::flip, true)}}),
      inScan("there is no crest between", 1.0,
             [&](Ridge& r) {
               through({{8.0, 15.0, 1.0}, {52.0, 14.0, 1.0}})(r), width(3.0)(r);
             },
             {{"setHalfWidth", width(12.0)}}),
      inScan("there is no crest between", 10.0,
             [&](Ridge& r) {
               besideFlat(r), through({{8.0, 48.0, 0.0}, {52.0, 49.0, 0.0}})(r);
             },
             {{"setRoughPoints", rough}}),
      inScan("because the scan ends there", 10.0, width(30.0), {{"setHalfWidth", width(9.0)}}),
  });
}

} // namespace ridge_remedies_test
