// A dome with a screw and some false echoes: its spiral as a program, whose leads are held against the scan, with the
// echoes and without them.
#include <pcl_spiral/machine/machine_program_generator.h>
#include <pcl_spiral/surface/stray_removal.h>
#include <pcl_spiral/toolpath/spiral_toolpath_generator.h>
#include <pcl_spiral/verify/lead_check.h>

#include <cmath>
#include <cstdio>
#include <random>

using namespace pcl_spiral;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

static void
look(const char* name, const Cloud::ConstPtr& scan, const MachineProgram& program)
{
  LeadCheck<pcl::PointXYZ> check;
  check.setInputCloud(scan);
  check.setCutter(CutterShape::ball(5.0));
  check.compute(program);
  const LeadFigures& f = check.getFigures();
  std::printf("%s: %zu of %zu moves off the path touch", name, f.collided, f.moves);
  if (f.collided > 0)
    std::printf(", the deepest point %.2f mm inside at (%.1f, %.1f, %.1f)", f.deepest.depth, f.deepest.place.x(),
                f.deepest.place.y(), f.deepest.place.z());
  std::printf("; %s\n", check.getStatus().message().c_str());
}

int
main()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  const Cloud::Ptr scan(new Cloud);
  for (int i = 0; i < 20000; ++i) {
    const float x = 40.0f * unit(random), y = 40.0f * unit(random);
    scan->push_back({x, y, std::sqrt(120.0f * 120.0f - x * x - y * y)});
  }
  for (int i = 0; i < 150; ++i) // echoes in the air
    scan->push_back({40.0f * unit(random), 40.0f * unit(random), 150.0f + 20.0f * unit(random)});
  for (int i = 0; i < 12; ++i) // a screw over the middle
    scan->push_back({2.0f * unit(random), 2.0f * unit(random), 128.0f + 0.5f * unit(random)});

  SpiralToolpathGenerator<pcl::PointXYZ> spiral; // leaves both out
  spiral.setInputCloud(scan);
  spiral.setToolRadius(5.0);
  spiral.setScallopHeight(0.1);
  spiral.setChordError(0.01);
  pcl::PointCloud<ToolpathPoint> path;
  spiral.compute(path);
  MachineProgramGenerator generator;
  generator.setMachine(xyzacTrunnion());
  generator.setInputPath(path, 5.0);
  MachineProgram program;
  generator.compute(program);
  if (!generator.getStatus().ok())
    return 1;

  look("all points", scan, program);
  StrayRemoval<pcl::PointXYZ> echoes;
  echoes.setInputCloud(scan);
  echoes.setLargestGroup(3); // what hangs together is no echo
  const Cloud::Ptr without(new Cloud);
  echoes.filter(*without);
  std::printf("%zu echoes left out, %zu points of groups kept\n", echoes.getFigures().strays,
              echoes.getFigures().kept_strays);
  look("without echoes", without, program);
  return echoes.getStatus().ok() ? 0 : 1;
}
