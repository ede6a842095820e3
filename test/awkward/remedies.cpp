// SPDX-License-Identifier: BSD-3-Clause
#include "remedies.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>

namespace pcl_spiral::awkward {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

const std::string number = "(-?[0-9.e+]+)";
const std::string place = "\\(" + number + ", " + number + ", " + number + "\\)";

/** The matches of \p pattern in \p text. */
std::vector<std::smatch>
matches(const std::string& text, const std::string& pattern)
{
  const std::regex expression(pattern);
  return {std::sregex_iterator(text.begin(), text.end(), expression), std::sregex_iterator()};
}

/** Three numbers of a match, from \p first. */
Vector3d
placeOf(const std::smatch& match, std::size_t first)
{
  return {std::stod(match[first]), std::stod(match[first + 1]), std::stod(match[first + 2])};
}

/** --keep-out with a rectangle in the coordinates of the file, written to a file of its own. */
void
addKeepOut(const Vector2d& low, const Vector2d& high, const std::string& prefix, const ScratchFolder& folder, Remedy& remedy)
{
  const std::string file = prefix + "keep" + std::to_string(remedy.arguments.size()) + ".txt";
  std::ostringstream text;
  for (const Vector2d& p : {low, Vector2d(high.x(), low.y()), high, Vector2d(low.x(), high.y())})
    text << p.transpose() << '\n';
  writeText(folder.path(file), text.str());
  remedy.arguments.insert(remedy.arguments.end(), {"--keep-out", file});
}

/** A place of the message that is on the part. */
void
addPartAt(const Scene& scene, const std::string& said, std::vector<Remedy>& remedies)
{
  for (const std::smatch& match : matches(said, "mm2 at " + place)) {
    const Vector3d at = placeOf(match, 1), p = scene.motion.inverse() * (scene.unit * at), foot = scene.part->closest(p);
    if ((p - foot).norm() > 1.0 || !scene.part->contains(foot))
      continue;
    remedies.push_back({"--part-at", {"--part-at", match[1].str() + "," + match[2].str() + "," + match[3].str()}});
    return;
  }
}

/** Polygons about what stands there, a little wider. */
void
addExtents(const std::string& said, const std::string& prefix, const ScratchFolder& folder, std::vector<Remedy>& remedies)
{
  const Vector2d wider = Vector2d::Constant(0.5); // mm
  Remedy remedy{"--keep-out", {}};
  for (const std::smatch& match : matches(said, "from " + place + " to " + place))
    addKeepOut(placeOf(match, 1).head<2>() - wider, placeOf(match, 4).head<2>() + wider, prefix, folder, remedy);
  if (!remedy.arguments.empty())
    remedies.push_back(remedy);
}

/** What is said of clusters: ride over them, if the ball is as large as it must be, or polygons about them. */
void
addClusters(const Scene& scene, const std::string& said, const std::string& prefix, const ScratchFolder& folder,
            std::vector<Remedy>& remedies)
{
  const std::vector<std::smatch> radius = matches(said, "with a ball of radius " + number + " mm or more");
  if (radius.empty() || scene.radius >= std::stod(radius.front()[1]))
    remedies.push_back({"--clusters ride", {"--clusters", "ride"}});
  if (!std::regex_search(said, std::regex("and [0-9]+ more")))
    addExtents(said, prefix, folder, remedies);
}

/** The keep-outs of \p arguments again, larger by as much as the message says: boxes about them. */
void
addLarger(const std::vector<std::string>& arguments, const std::string& said, const std::string& prefix, const ScratchFolder& folder,
          std::vector<Remedy>& remedies)
{
  Remedy remedy{"--keep-out larger", {}};
  const double larger = std::stod(matches(said, "(?:by|cut) " + number + " mm").front()[1]) + 0.01;
  for (std::size_t i = 0; i + 1 < arguments.size(); ++i) {
    if (arguments[i] != "--keep-out")
      continue;
    std::istringstream text(readText(folder.path(arguments[i + 1])));
    Eigen::AlignedBox2d box;
    for (Vector2d p; text >> p.x() >> p.y();)
      box.extend(p);
    addKeepOut(box.min() - Vector2d::Constant(larger), box.max() + Vector2d::Constant(larger), prefix, folder, remedy);
  }
  remedies.push_back(remedy);
}

} // namespace

std::vector<Remedy>
remediesOf(const Scene& scene, const std::vector<std::string>& arguments, const std::string& said, const std::string& prefix,
           const ScratchFolder& folder)
{
  const auto names = [&](const std::string& words) { return said.find(words) != std::string::npos; };
  const auto given = [&](const char* option) { return std::find(arguments.begin(), arguments.end(), option) != arguments.end(); };
  std::vector<Remedy> remedies;
  if (names("(--part-at)"))
    addPartAt(scene, said, remedies);
  if (names("--clusters ride"))
    addClusters(scene, said, prefix, folder, remedies);
  else if (names("(--keep-out)"))
    addExtents(said, prefix, folder, remedies);
  if (names("enlarge the polygon there by that much (--keep-out)"))
    addLarger(arguments, said, prefix, folder, remedies);
  if (names("tilt the tool less"))
    remedies.push_back({"--tilt 0", {"--tilt", "0"}});
  if (names("the radial method (--method)") && !given("--method"))
    remedies.push_back({"--method radial", {"--method", "radial"}});
  if (names("another scallop height (--scallop)"))
    remedies.push_back({"--scallop", {}, 0.0, 0.7 * scene.scallop});
  if (names("the other sense (--sense)") && !given("--sense"))
    remedies.push_back({"--sense cw", {"--sense", "cw"}});
  for (const std::smatch& match : matches(said, "use a smaller tool(?: \\(--tool-radius\\))?: a radius of " + number + " mm"))
    remedies.push_back({"--tool-radius", {}, std::stod(match[1])});
  return remedies;
}

} // namespace pcl_spiral::awkward
