// SPDX-License-Identifier: BSD-3-Clause
#include "job.h"

#include <chrono>
#include <stdexcept>

namespace pcl_spiral::acceptance {

namespace {

/** Rows that share their cutter: name, surface, points and the largest deviation allowed. */
Job
patch(const std::string& name, test::SurfacePtr surface)
{
  Job j;
  j.name = name;
  j.surface = std::move(surface);
  j.points = 30000;
  j.tool_radius = 5.0;
  j.scallop_height = 0.02;
  j.chord_error = 0.003;
  j.deviation_max = 0.003;
  return j;
}

Job
dome(const std::string& name, double hole)
{
  Job j;
  j.name = name;
  j.surface = test::spheroidCap(1650.0, 860.0, hole);
  j.points = 200000;
  j.tool_radius = 10.0;
  j.scallop_height = 0.05;
  j.chord_error = 0.005;
  j.deviation_max = 0.003;
  j.length_ratio = 1.03;
  j.samples = 100000;
  return j;
}

Job
freeform()
{
  Job j;
  j.name = "freeform";
  j.surface = test::freeform();
  j.points = 86000;
  j.tool_radius = 10.0;
  j.scallop_height = 0.05;
  j.chord_error = 0.005;
  j.deviation_p99 = 0.003;
  j.deviation_max = 0.02;
  j.samples = 100000;
  return j;
}

Job
noisyDome()
{
  Job j = dome("noisy", 0.0);
  j.noise = 0.02;
  j.deviation_rms = 0.007;
  j.deviation_max = 0.04;
  j.scallop = false;
  j.length_ratio = 0.0;
  j.turning = 20.0;
  return j;
}

/** Two million points: the size that the planner is designed for. */
Job
largeDome(const std::string& name, double noise)
{
  Job j = dome(name, 0.0);
  j.points = 2000000;
  j.noise = noise;
  j.deviation_max = noise > 0.0 ? 0.06 : 0.0005;
  j.scallop = noise == 0.0;
  j.length_ratio = noise > 0.0 ? 0.0 : 1.025;
  return j;
}

Job
smallRound(const std::string& name, test::SurfacePtr surface, double radius, double h)
{
  Job j = patch(name, std::move(surface));
  j.points = 40000;
  j.tool_radius = radius;
  j.scallop_height = h;
  j.chord_error = 0.002;
  return j;
}

} // namespace

std::vector<Job>
jobs()
{
  std::vector<Job> all{freeform(),
                       dome("dome200k", 0.0),
                       dome("dome200k_annulus", 260.0),
                       smallRound("cap80", test::spheroidCap(80.0, 45.0), 3.0, 0.01),
                       smallRound("bowl", test::bowl(), 6.0, 0.02),
                       patch("saddle", test::ovalSaddle()),
                       patch("annulus", test::offCentreAnnulus()),
                       patch("kidney", test::kidneyPatch()),
                       patch("ell", test::ellPatch()),
                       patch("boomerang", test::boomerangPatch()),
                       noisyDome(),
                       largeDome("dome2m", 0.0),
                       largeDome("dome2m_noisy", 0.05)};
  for (Job& j : all)
    j.may_refuse = j.name == "boomerang";
  return all;
}

std::vector<Job>
secondCloudJobs()
{
  std::vector<Job> all{dome("published1", 0.0), freeform()};
  all[0].points = 2000000;
  all[1].name = "published2";
  for (Job& j : all) {
    j.scallop_height = 0.01;
    j.deviation_max = 0.0005;
    j.machined_max = 0.016;
  }
  for (const std::size_t i : {0, 1}) {
    all.push_back(all[i]);
    all.back().name += "_noisy";
    all.back().noise = 0.02;
    all.back().deviation_max = 0.02;
    all.back().machined_max = 0.035;
  }
  all.push_back(dome("million", 0.0));
  all.back().points = 1000000;
  all.back().judge_seconds = 60.0;
  return all;
}

Job
job(const std::string& name)
{
  for (const Job& j : jobs())
    if (j.name == name)
      return j;
  throw std::out_of_range("no acceptance row named " + name);
}

test::Sampled
sampled(const Job& job, std::uint64_t seed)
{
  test::Sampled points = test::sampleUniform(*job.surface, job.points, seed);
  if (job.noise > 0.0)
    test::addNoise(points, job.noise, seed + 1000);
  return points;
}

Run
run(const Job& job, const Cloud::ConstPtr& cloud, int threads, const Eigen::Vector3d* view, const Eigen::Vector3d* start, SpiralSense sense)
{
  Generator generator;
  generator.setInputCloud(cloud);
  generator.setMethod(SpiralMethod::Radial); // outlines by the other method: acceptance_outlines
  generator.setToolRadius(job.tool_radius);
  generator.setScallopHeight(job.scallop_height);
  generator.setChordError(job.chord_error);
  generator.setNumberOfThreads(threads);
  generator.setSense(sense);
  if (view)
    generator.setViewPoint(*view);
  if (start)
    generator.setStartPoint(*start);
  Run result;
  const auto from = std::chrono::steady_clock::now();
  generator.compute(result.path);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
  result.report = generator.getReport();
  result.status = generator.getStatus();
  return result;
}

} // namespace pcl_spiral::acceptance
