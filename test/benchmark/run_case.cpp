// SPDX-License-Identifier: BSD-3-Clause
#include "run_case.h"

#include <cmath>
#include <stdexcept>

namespace pcl_spiral::benchmarks {

namespace {

/** Edge of the voxels such that a surface of \p area occupies \p count of them: 3/2 area / edge^2, because the sum of the absolute
 * components of a unit normal is 3/2 in the mean. */
double
voxelEdge(double area, double count)
{
  return std::sqrt(1.5 * area / count);
}

RunCase
dome(const std::string& name, std::size_t points)
{
  return {name, {domeSurface(), points}, {}, true};
}

RunCase
rawDome(const std::string& name)
{
  RunCase raw = dome(name, 12000000);
  raw.cloud.noise = 0.05;
  raw.cloud.false_echoes = 0.01;
  raw.settings.outlier_neighbours = 16;
  raw.settings.outlier_deviations = 2.0;
  raw.settings.thinning = voxelEdge(raw.cloud.surface->area(), 2e6);
  return raw;
}

/** The method for the end of a case's name. */
SpiralMethod
methodNamed(const std::string& name)
{
  if (name == "default")
    return SpiralSettings().method;
  if (name == "published")
    return SpiralMethod::Published;
  if (name == "scallop")
    return SpiralMethod::ConstantScallop;
  throw std::invalid_argument("there is no method named " + name);
}

} // namespace

const std::vector<std::string>&
caseNames()
{
  static const std::vector<std::string> names{"dome",
                                              "dome200k",
                                              "freeform",
                                              "dome12",
                                              "dome_default",
                                              "dome200k_default",
                                              "freeform_default",
                                              "dome_scallop",
                                              "dome200k_scallop",
                                              "freeform_scallop",
                                              "dome200k_published",
                                              "freeform_published"};
  return names;
}

RunCase
runCase(const std::string& name, double scallop)
{
  RunCase chosen;
  if (name == "dome")
    chosen = dome(name, 2000000);
  else if (name == "dome200k")
    chosen = dome(name, 200000);
  else if (name == "freeform")
    chosen = {name, {test::freeform(), 86000}, {}, false};
  else if (const std::size_t end = name.find('_'); end != std::string::npos) {
    chosen = runCase(name.substr(0, end), scallop);
    chosen.name = name;
    chosen.settings.method = methodNamed(name.substr(end + 1));
    return chosen;
  }
  else if (name == "dome12")
    chosen = rawDome(name);
  else
    throw std::invalid_argument("there is no case named " + name);
  chosen.settings.method = SpiralMethod::Radial;
  chosen.settings.tool_radius = 10.0;
  chosen.settings.scallop_height = scallop;
  chosen.settings.chord_error = 0.005;
  return chosen;
}

} // namespace pcl_spiral::benchmarks
