// SPDX-License-Identifier: BSD-3-Clause
// Passes that are refused or warned of: each remedy that the message names helps.
#include "support/plain_mesh.h"
#include "support/plate_scans.h"
#include "support/remedies.h"
#include "support/tight_parts.h"

#include <pcl_spiral/planning/drive_planner.h>

#include <gtest/gtest.h>

namespace drive_remedies_test {
namespace {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;
using Drive = DrivePlanner<pcl::PointXYZ>;
using Change = test::Change<Drive>;
using Remedies = std::vector<Remedy<Drive>>;

Said
say(Drive& planner)
{
  planner.compute();
  return {planner.getStatus(), planner.getWarnings()};
}

void
setTool(Drive& planner)
{
  planner.setCutter(CutterShape::ball(3.0));
  planner.setStepOver(1.5);
}

/** Passes over \p scan, with \p change. */
RemediedJob
over(const std::function<ScanPtr()>& scan, const char* words, const Change& change, const Remedies& remedies)
{
  const Change prepare = [scan, change](Drive& planner) {
    planner.setInputCloud(scan());
    setTool(planner);
    change(planner);
  };
  return remediedJob<Drive>(words, say, prepare, remedies);
}

/** The same over a plate. */
RemediedJob
onPlate(const char* words, const Change& change, const Remedies& remedies)
{
  return over([] { return plate(10.0); }, words, change, remedies);
}

/** The same over a mesh. */
RemediedJob
onMesh(const char* words, const Change& change, const Remedies& remedies)
{
  const Change prepare = [change](Drive& planner) {
    planner.setInputMesh(graphMesh([](double x, double y) { return -0.002 * (x * x + y * y); }, 6.0, 1.5).surface());
    setTool(planner);
    change(planner);
  };
  return remediedJob<Drive>(words, say, prepare, remedies);
}

Change
pass(double PassSettings::*member, double value)
{
  return [=](Drive& d) {
    PassSettings settings = d.getPassSettings();
    settings.*member = value;
    d.setPassSettings(settings);
  };
}

/** A part of a tube along y, over \p half of its turn to either side of +z. */
ScanPtr
tubeOver(double half, const Eigen::Matrix3d& turned)
{
  const ScanPtr scan(new pcl::PointCloud<pcl::PointXYZ>);
  addSheet(
      8.0 * half, 8.0, 0.8,
      [&](double u, double v) { return Vector3d(turned * Vector3d(8.0 * std::sin(u / 8.0), v, 8.0 * std::cos(u / 8.0))); }, *scan);
  return scan;
}

ScanPtr
tube()
{
  return tubeOver(1.2, Eigen::Matrix3d::Identity());
}

/** A whole tube along z. */
ScanPtr
column()
{
  return tubeOver(M_PI, Eigen::AngleAxisd(0.5 * M_PI, Vector3d::UnitX()).toRotationMatrix());
}

const auto planes = [](Drive& d) { d.setKind(DriveKind::Planes); };
const auto even = [](Drive& d) { d.setRows(DriveRows::Even); };
const auto kept = [](Drive& d) {
  d.setToolRadius(3.0);
  d.setScallopHeight(0.05);
  d.setRows(DriveRows::Kept);
};

} // namespace

TEST(DriveRemedies, Ranges)
{
  const auto step = [](double step) { return [step](Drive& d) { d.setStepOver(step); }; };
  const auto cutter = [](double radius) { return [radius](Drive& d) { d.setCutter(CutterShape::ball(radius)); }; };
  const auto curve = [](Drive& d) { d.setCurve({{-5.0, 0.0, 0.0}, {5.0, 0.0, 0.0}}); };
  const auto angle = [](Drive& d) { d.setPlaneDirection(0.0), d.setPlaneDirection(Vector3d::UnitX()); };
  expectNoFaults({
      remediedJob<Drive>("the cutter is missing", say, [](Drive& d) { d.setInputCloud(plate(10.0)), d.setStepOver(1.5); },
                         {{"setCutter", cutter(3.0)}}),
      onPlate("the cutter ({setCutter}): ", cutter(-3.0), {{"setCutter", cutter(3.0)}}),
      onPlate("the step-over is ", step(-1.0), {{"setStepOver", step(1.0)}}),
      onPlate("the tool axis is ", [](Drive& d) { d.setAxis(Vector3d::Zero()); },
              {{"setAxis", [](Drive& d) { d.setAxis(Vector3d::UnitZ()); }}}),
      onPlate("they define no plane", [](Drive& d) { d.setPlaneDirection(Vector3d::UnitZ()); }, {{"setPlaneDirection", angle}}),
      onPlate("the direction of the section planes is not finite", [](Drive& d) { d.setPlaneDirection(Vector3d::Constant(NAN)); },
              {{"setPlaneDirection", angle}}),
      onPlate("the curve has ", [](Drive& d) { d.setKind(DriveKind::Curve); }, {{"setCurve", curve}}),
      onPlate("the spacing of drive points is ", [](Drive& d) { d.setPointSpacing(0.0); },
              {{"setPointSpacing", [](Drive& d) { d.setPointSpacing(1.0); }}}),
      onPlate("the tolerance is ", pass(&PassSettings::tolerance, 0.0),
              {{"PassSettings::tolerance", pass(&PassSettings::tolerance, 0.01)}}),
      onPlate("the ceiling is ", pass(&PassSettings::ceiling, 1.0), {{"PassSettings::ceiling", pass(&PassSettings::ceiling, 100.0)}}),
      onPlate("this drive path would be too large", step(1e-7),
              {{"setStepOver", step(1.0)}, {"ReadOptions::unit", [](Drive& d) { d.setInputCloud(plate(1e-4, 1e-5)); }}}),
      onPlate("this drive path would be too large", [](Drive& d) { d.setPointSpacing(1e-9); },
              {{"setPointSpacing", [](Drive& d) { d.setPointSpacing(1.0); }}}),
  });
}

TEST(DriveRemedies, Contradictions)
{
  const auto offset = [](Drive& d) { d.setKind(DriveKind::BoundaryOffset); };
  const auto unlinked = [](Drive& d) { d.setLinkRows(false); };
  expectNoFaults({
      onPlate("only rows of section planes can be linked", [&](Drive& d) { offset(d), d.setLinkRows(true); },
              {{"setKind", planes}, {"setLinkRows", unlinked}}),
      onPlate("one-way rows begin far from", [](Drive& d) { d.setZigzag(false), d.setLinkRows(true); },
              {{"setZigzag", [](Drive& d) { d.setZigzag(true); }}, {"setLinkRows", unlinked}}),
      over(disc, "only section planes can keep rows to a scallop height", [&](Drive& d) { kept(d), offset(d); },
           {{"setKind", planes},
            {"setRows",
             [](Drive& d) {
               d.setRows(DriveRows::Even), d.setToolRadius(3.0);
               d.setScallopHeight(0.0);
             }}}),
      over(tube, "not to a cylinder",
           [](Drive& d) {
             kept(d), d.setAxisMode(DriveAxisMode::Cylinder), d.setCylinder(DriveCylinder{Vector3d::Zero(), Vector3d::UnitY()});
           },
           {{"setAxisMode", [](Drive& d) { d.setAxisMode(DriveAxisMode::Surface); }},
            {"setRows",
             [](Drive& d) {
               even(d), d.setToolRadius(3.0);
               d.setScallopHeight(0.0);
             }}}),
      onPlate("for rows kept to a scallop height",
              [](Drive& d) { d.setToolRadius(3.0), d.setScallopHeight(5.0), d.setRows(DriveRows::Kept); },
              {{"setCutter", [](Drive& d) { d.setCutter(CutterShape::ball(60.0)); }},
               {"setScallopHeight",
                [](Drive& d) {
                  d.setToolRadius(3.0);
                  d.setScallopHeight(0.05);
                }}}),
      onMesh("offsets of the boundary run over the points of a scan", offset,
             {{"setKind", planes}, {"setInputCloud", [](Drive& d) { d.setInputCloud(plate(10.0)); }}}),
      onMesh("leave it on",
             [](Drive& d) {
               d.setGougeCheck(false), d.setKind(DriveKind::Curve), d.setCurve({{-5, 0, 0}, {5, 0, 0}});
             },
             {{"setGougeCheck", [](Drive& d) { d.setGougeCheck(true); }}}),
      onMesh("belongs to scans, and a mesh is given", [](Drive& d) { d.setLeaveOutStrays(true); },
             {{"setLeaveOutStrays", [](Drive& d) { d.setLeaveOutStrays(false); }},
              {"setInputMesh", [](Drive& d) { d.setInputCloud(plate(10.0)); }}}),
  });
}

TEST(DriveRemedies, Input)
{
  const auto give = [](Drive& d) { d.setInputCloud(plate(10.0)); };
  expectNoFaults({
      remediedJob<Drive>(
          "the input cloud is missing", say, setTool,
          {{"setInputCloud", give},
           {"setInputMesh", [](Drive& d) { d.setInputMesh(graphMesh([](double, double) { return 0.0; }, 6.0, 1.5).surface()); }}}),
  });
}

TEST(DriveRemedies, Scallop)
{
  const auto groove = [] { return valley(0.9, 3.5, 9.0, 9.0).scan(0.5, 0.0, 11); };
  const auto instead = [](Drive& d, const Diagnostic& said) {
    d.setToolRadius(3.0), d.setScallopHeight(0.0), d.setStepOver(said.numbers().at(3));
  };
  expectNoFaults({
      over(groove, "the passes leave more than the {setScallopHeight}",
           [](Drive& d) { d.setStepOver(0.0), d.setToolRadius(3.0), d.setScallopHeight(0.02), d.setPlaneDirection(90.0); },
           {{"setRows", [](Drive& d) { d.setRows(DriveRows::Kept); }}, {"setStepOver", instead}, {"setScallopHeight", instead}}),
  });
}

TEST(DriveRemedies, TheTool)
{
  const auto wall = [] {
    const ScanPtr scan = plate(7.0);
    addSheet(
        7.0, 8.0, 0.8, [](double u, double v) { return Vector3d(7.0, u, v + 8.0); }, *scan);
    return scan;
  };
  const auto echo = [] {
    const ScanPtr scan = plate(10.0);
    scan->emplace_back(0.0f, 0.0f, 8.0f);
    return scan;
  };
  const auto chuck = [](Drive& d) {
    d.setCutter(CutterShape::ball(3.0, 5.0));
    d.setPlaneDirection(90.0); // along the wall
    d.setHolder({ToolSegment::cylinder(4.5, 30.0, "chuck")});
  };
  const auto surface = [](Drive& d) { d.setAxisMode(DriveAxisMode::Surface); };
  const auto rate = [](double most) { return pass(&PassSettings::max_axis_rate, most); };
  const auto smoothing = [](double over) { return pass(&PassSettings::axis_smoothing, over); };
  expectNoFaults({
      over(wall, "use a longer or thinner tool", chuck,
           {{"PassSettings::max_retilt", pass(&PassSettings::max_retilt, 30.0)},
            {"setAcceptCollisions", [](Drive& d) { d.setAcceptCollisions(true); }}}),
      over(wall, "axes would lean", [&](Drive& d) { surface(d), rate(0.1)(d); }, {{"PassSettings::max_axis_rate", rate(0.0)}}),
      over(wall, "axes would lean", [&](Drive& d) { surface(d), rate(0.1)(d), smoothing(100.0)(d); },
           {{"PassSettings::axis_smoothing", [&](Drive& d) { rate(0.0)(d), smoothing(1.0)(d); }}}),
      over(wall, "of the surface is not cut", {},
           {{"setAxis",
             [](Drive& d) {
               d.setAxis({-1.0, 0.0, 1.0});
             }}}),
      over(column, "of the surface is not cut", {}, {{"setKind", [](Drive& d) { d.setKind(DriveKind::Helix); }}}),
      over(echo, "remove them first if they are false echoes", {}, {{"OutlierRemoval", [](Drive& d) { d.setLeaveOutStrays(true); }}}),
  });
}

} // namespace drive_remedies_test
