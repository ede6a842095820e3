// SPDX-License-Identifier: BSD-3-Clause
// Programs and verifications that are refused: each remedy that the message names helps.
#include "support/plain_mesh.h"
#include "support/plate_scans.h"
#include "support/remedies.h"

#include <pcl_spiral/planning/drive_planner.h>
#include <pcl_spiral/planning/path_verifier.h>
#include <pcl_spiral/planning/program_planner.h>
#include <pcl_spiral/planning/spiral_planner.h>

#include <gtest/gtest.h>

namespace program_remedies_test {
namespace {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

/** A spiral over a plate, and its program. */
struct Job {
  SpiralPlanner<pcl::PointXYZ> spiral;
  ProgramPlanner program;
  ProgramSettings settings;
  Machine machine = xyzacTrunnion();

  Job()
  {
    spiral.setInputCloud(plate(10.0));
    spiral.setToolRadius(3.0);
    spiral.setScallopHeight(0.05);
  }
  void setQuiet(bool quiet)
  {
    spiral.setQuiet(quiet);
    program.setQuiet(quiet);
  }
};

/** The same with rows of a ball over a mesh. */
struct RowJob : Job {
  DrivePlanner<pcl::PointXYZ> rows;

  RowJob()
  {
    rows.setQuiet(true);
    rows.setInputMesh(graphMesh([](double x, double y) { return -0.02 * (x * x + y * y); }, 10.0, 1.0).surface());
    rows.setCutter(CutterShape::ball(3.0));
    rows.setStepOver(2.0);
  }
};

template <typename Plan>
Said
sayOf(Job& job, const Plan& plan)
{
  job.program.setInputPlan(plan);
  job.program.setMachine(job.machine);
  job.program.setSettings(job.settings);
  MachineProgram program;
  job.program.compute(program);
  return {job.program.getStatus(), job.program.getWarnings()};
}

Said
say(Job& job)
{
  job.spiral.compute();
  return job.spiral.getStatus().ok() ? sayOf(job, job.spiral.getPlan()) : Said{job.spiral.getStatus(), {}};
}

Said
sayRows(RowJob& job)
{
  job.rows.compute();
  return job.rows.getStatus().ok() ? sayOf(job, job.rows.getPlan()) : Said{job.rows.getStatus(), {}};
}

Said
sayUnplanned(Job& job)
{
  return job.spiral.getToolRadius() > 4.0 ? sayOf(job, SpiralPlan()) : say(job);
}

Change<Job>
set(double ProgramSettings::*member, double value)
{
  return [=](Job& job) { job.settings.*member = value; };
}

using Verifier = PathVerifier<pcl::PointXYZ>;

Said
judge(Verifier& verifier)
{
  Verification verification;
  verifier.compute(verification);
  return {verifier.getStatus(), {}};
}

const pcl::PointCloud<ToolpathPoint>::Ptr&
path()
{
  static const pcl::PointCloud<ToolpathPoint>::Ptr made = [] {
    Job job;
    job.spiral.compute();
    return job.spiral.getPlan().path;
  }();
  return made;
}

RemediedJob
judged(const char* words, const Change<Verifier>& change, const std::vector<Remedy<Verifier>>& remedies)
{
  const Change<Verifier> prepare = [change](Verifier& v) {
    v.setInputCloud(plate(10.0));
    v.setInputToolpath(path());
    v.setCutter(CutterShape::ball(3.0));
    change(v);
  };
  return remediedJob<Verifier>(words, judge, prepare, remedies);
}

} // namespace

TEST(ProgramRemedies, OfASpiral)
{
  using S = ProgramSettings;
  const auto threeAxes = [](Job& job) {
    job.machine = Machine();
    job.machine.three_axes = true;
  };
  expectNoFaults({
      remediedJob<Job>("there is no plan with a path", sayUnplanned, [](Job& job) { job.spiral.setToolRadius(5.0); },
                       {{"setInputPlan", [](Job& job) { job.spiral.setToolRadius(3.0); }}}),
      remediedJob<Job>("the lead length is ", say, set(&S::lead_length, 0.0),
                       {{"ProgramSettings::lead_length", set(&S::lead_length, 2.0)}}),
      remediedJob<Job>("the rapid height is ", say, set(&S::rapid_height, -1.0),
                       {{"ProgramSettings::rapid_height", set(&S::rapid_height, 50.0)}}),
      remediedJob<Job>("the pole cone is ", say, set(&S::pole_cone, 90.0), {{"ProgramSettings::pole_cone", set(&S::pole_cone, 2.0)}}),
      remediedJob<Job>("the plunge feed is ", say, set(&S::plunge_feed, -1.0),
                       {{"ProgramSettings::plunge_feed", set(&S::plunge_feed, 500.0)}}),
      remediedJob<Job>("a machine with three axes cannot tilt the tool", say, threeAxes,
                       {{"setFixedAxis", [](Job& job) { job.spiral.setFixedAxis(Vector3d::UnitZ()); }}}),
  });
}

TEST(ProgramRemedies, OfRowsOverAMesh)
{
  const auto low = [](RowJob& job) { // the tool crosses the crest while it still leans
    const auto hill = [](double x, double) { return 3.3 - std::hypot(3.3, x + 8.0); };
    job.rows.setInputMesh(graphMesh(hill, 10.0, 0.5).surface());
    job.rows.setAxisMode(DriveAxisMode::Surface);
    job.rows.setZigzag(false);
    job.settings.rapid_height = job.settings.lead_length = job.settings.clearance = 0.1;
  };
  expectNoFaults({
      remediedJob<RowJob>("leads were not checked", sayRows, [](RowJob& job) { job.rows.setSampleMesh(false); },
                          {{"setSampleMesh", [](RowJob& job) { job.rows.setSampleMesh(true); }}}),
      remediedJob<RowJob>("no link stays near the surface", sayRows,
                          [](RowJob& job) { job.rows.setSampleMesh(false), job.settings.stay_down = 20.0; },
                          {{"ProgramSettings::stay_down", [](RowJob& job) { job.settings.stay_down = 0.0; }}}),
      remediedJob<RowJob>("raise the rapids", sayRows, low,
                          {{"ProgramSettings::rapid_height", [](RowJob& job) { job.settings.rapid_height = 50.0; }},
                           {"setAcceptCollisions", [](RowJob& job) { job.rows.setAcceptCollisions(true); }}}),
  });
}

TEST(ProgramRemedies, OfAJudge)
{
  const auto raw = [](Verifier& v) { v.setRawScan(plate(10.0)); };
  const auto mesh = [](Verifier& v) {
    v.setInputMesh(graphMesh([](double x, double y) { return -0.002 * (x * x + y * y); }, 10.0, 1.0).surface());
  };
  const auto give = [](Verifier& v) { v.setInputCloud(plate(10.0)); };
  const auto region = [](double x) { return PlanRegion{std::nullopt, Vector3d(x, 0.0, 0.0), ""}; };
  expectNoFaults({
      judged("the path is missing or empty", [](Verifier& v) { v.setInputToolpath(nullptr); },
             {{"setInputToolpath", [](Verifier& v) { v.setInputToolpath(path()); }}}),
      judged("the input cloud is missing", [](Verifier& v) { v.setInputCloud(nullptr); },
             {{"setInputCloud", give}, {"setInputMesh", mesh}}),
      judged("tips: give one tip for each point", [](Verifier& v) { v.setInputTips({Vector3d::Zero()}); },
             {{"setInputTips", [](Verifier& v) { v.setInputTips({}); }}}),
      judged("the cutter is missing", [](Verifier& v) { v.setCutter(CutterShape::ball(0.0)); },
             {{"setCutter", [](Verifier& v) { v.setCutter(CutterShape::ball(3.0)); }}}),
      judged("a path is judged by all points", [](Verifier& v) { v.setThinning(1.0); },
             {{"setThinning", [](Verifier& v) { v.setThinning(0.0); }}}),
      judged("a path is judged by all points", [](Verifier& v) { v.setOutlierRemoval(8); },
             {{"setOutlierRemoval", [](Verifier& v) { v.setOutlierRemoval(0); }}}),
      judged("belongs to scans, and a mesh is given", [&](Verifier& v) { mesh(v), raw(v); },
             {{"setRawScan", [](Verifier& v) { v.setRawScan(nullptr); }}, {"setInputMesh", give}}),
      judged("each has a verification", [&](Verifier& v) { v.addRegion(region(0.0)), v.addRegion(region(1.0)); },
             {{"addRegion", [](Verifier& v) { v.clearPart(); }}}),
  });
}

} // namespace program_remedies_test
