// SPDX-License-Identifier: BSD-3-Clause
#include "refused_input.h"

#include "awkward/drawn_part.h"
#include "support/range_view.h"
#include "support/tight_parts.h"

#include <pcl_spiral/core/impl/angles.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

namespace pcl_spiral::followed {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/** A scan of \p part with points \p spacing apart. */
void
scanPart(const test::AnalyticSurface& part, double spacing, double noise, test::Random& random, RefusedInput& input)
{
  const auto count = static_cast<std::size_t>(1.6 * part.area() / (spacing * spacing));
  test::Sampled scan = test::sampleUniform(part, count, random.below(1u << 30));
  test::addNoise(scan, noise, random.below(1u << 30));
  input.points.insert(input.points.end(), scan.points.begin(), scan.points.end());
  input.spacing = spacing;
  input.noise = noise;
}

/** Scan and one of the commands of an awkward scene. */
void
ofScene(const char* kind, test::Random& random, RefusedInput& input)
{
  const awkward::Scene scene = awkward::makeScene(kind, 40 + random.below(1000), random.below(1000), 0.6);
  for (const Vector3d& p : scene.scan.points)
    input.points.push_back(scene.motion * p);
  input.noise = scene.noise;
  input.spacing = scene.spacing;
  input.radius = scene.radius;
  input.scallop = scene.scallop;
  input.arguments = scene.steps[random.below(scene.steps.size())].arguments;
  std::ostringstream polygon;
  for (const Vector2d& p : scene.keep_out)
    polygon << (scene.motion * Vector3d(p.x(), p.y(), 0.0)).head<2>().transpose() << '\n';
  if (!scene.keep_out.empty())
    input.files["keep.txt"] = polygon.str();
}

/** What a camera sees of a folded part, one row and column of \p every. */
void
viewFolded(int every, bool side_known, test::Random& random, RefusedInput& input)
{
  const auto kind = static_cast<test::FoldedPart>(random.below(4));
  input.noise = random.below(2) == 0 ? 0.0 : 0.05;
  const auto seed = static_cast<unsigned int>(random.below(1000));
  const auto view = test::rangeView(test::foldedPart(kind, seed), input.noise, seed);
  for (std::size_t row = 0; row < view->height; row += static_cast<std::size_t>(every))
    for (std::size_t column = 0; column < view->width; column += static_cast<std::size_t>(every))
      if (const auto& p = view->at(column, row); std::isfinite(p.x))
        input.points.push_back(p.getVector3fMap().cast<double>());
  input.spacing = 0.8 * every;
  if (side_known)
    input.sensor = {0, 0, 500};
  input.radius = random.uniform(3.0, 8.0);
  input.scallop = 0.04 * input.radius;
}

void
coarse(test::Random& random, RefusedInput& input)
{
  if (random.below(2) == 0)
    return viewFolded(4 + static_cast<int>(random.below(4)), random.below(2) == 0, random, input);
  const test::SurfacePtr part =
      test::waves({{random.uniform(1.0, 5.0), random.uniform(0.1, 0.4), random.uniform(0.1, 0.4), random.uniform(0.0, 6.0)}},
                  test::Region({test::rectangle(random.uniform(30.0, 60.0), random.uniform(20.0, 50.0))}));
  scanPart(*part, random.uniform(2.0, 5.0), 0.0, random, input);
}

void
folded(test::Random& random, RefusedInput& input)
{
  viewFolded(2 + static_cast<int>(random.below(2)), random.below(2) == 0, random, input);
}

/** A rectangle of a folded view. */
void
cropped(test::Random& random, RefusedInput& input)
{
  viewFolded(2, random.below(2) == 0, random, input);
  const Vector2d middle(random.uniform(-40.0, 40.0), random.uniform(-40.0, 40.0)),
      half(random.uniform(8.0, 40.0), random.uniform(8.0, 40.0));
  std::ostringstream box;
  box << middle.x() - half.x() << ',' << middle.x() + half.x() << ',' << middle.y() - half.y() << ',' << middle.y() + half.y();
  input.arguments = {"--crop", box.str()};
}

/** One sheet over the other, joined by nothing or by a wall. */
void
sheets(test::Random& random, RefusedInput& input)
{
  const double width = random.uniform(20.0, 50.0), height = random.uniform(20.0, 50.0), spacing = random.uniform(0.7, 1.2);
  const double above = random.uniform(0.5, 12.0), share = random.uniform(0.3, 1.0);
  const test::SurfacePtr lower = test::flat(test::Region({test::rectangle(width, height)}));
  const test::SurfacePtr upper = test::flat(test::Region({test::rectangle(share * width, share * height)}));
  scanPart(*upper, spacing, 0.01, random, input);
  for (Vector3d& p : input.points)
    p.z() += above;
  if (random.below(2) == 0) // the wall between them
    for (double y = -0.5 * share * height; y <= 0.5 * share * height; y += spacing)
      for (double z = spacing; z < above; z += spacing)
        input.points.emplace_back(0.5 * share * width, y, z);
  scanPart(*lower, spacing, 0.01, random, input);
  if (random.below(2) == 0)
    input.sensor = {0, 0, 400};
}

/** Keep-outs that leave little of the part between them. */
void
keptOut(test::Random& random, RefusedInput& input)
{
  const test::SurfacePtr part = awkward::drawnPart(random, 0.6);
  scanPart(*part, random.uniform(0.7, 1.2), 0.01, random, input);
  const std::size_t count = 1 + random.below(3);
  for (std::size_t i = 0; i < count; ++i) {
    awkward::Box box;
    box.centre = awkward::innerPlace(*part, 1.0, random).head<2>();
    box.half_x = random.uniform(1.0, 4.0);
    box.half_y = random.uniform(4.0, 20.0);
    box.turn = random.uniform(0.0, 3.0);
    std::ostringstream text;
    for (const Vector2d& p : box.outline())
      text << p.transpose() << '\n';
    const std::string name = "keep" + std::to_string(i) + ".txt";
    input.files[name] = text.str();
    input.arguments.insert(input.arguments.end(), {"--keep-out", name});
  }
}

/** A few points across. */
void
narrow(test::Random& random, RefusedInput& input)
{
  const double spacing = random.uniform(0.8, 1.5), across = random.uniform(3.0, 9.0) * spacing, length = random.uniform(20.0, 60.0);
  const test::PlaneLoop outline = random.below(2) == 0 ? test::rectangle(length, across) : test::ell(length, across);
  std::vector<test::PlaneLoop> loops{outline};
  if (random.below(3) == 0) { // a ring that is narrow on one side
    const double outer = random.uniform(15.0, 25.0), inner = random.uniform(5.0, 10.0);
    loops = {test::circle({0, 0}, outer), test::circle({outer - inner - across, 0.0}, inner)};
  }
  scanPart(*test::flat(test::Region(loops)), spacing, 0.0, random, input);
}

/** A fillet, a pit or a corner tighter than the ball, where no tight place is allowed. */
void
tight(test::Random& random, RefusedInput& input)
{
  const double fillet = random.uniform(1.5, 3.0);
  const test::TightPart part = random.below(2) == 0
                                   ? test::valley(random.uniform(0.3, 0.9), fillet, random.uniform(10.0, 18.0), random.uniform(10.0, 18.0))
                                   : test::ballOnPlane(random.uniform(6.0, 9.0), fillet, random.uniform(16.0, 22.0));
  const auto scan = part.scan(0.5, 0.0, static_cast<unsigned int>(random.below(10000)));
  for (const auto& p : *scan)
    input.points.push_back(p.getVector3fMap().cast<double>());
  input.spacing = 0.5;
  input.radius = fillet * random.uniform(1.2, 2.5);
  input.scallop = 0.03 * input.radius;
  input.arguments = {"--tight", "refuse"};
}

/** Noise of nearly a point spacing. */
void
noisy(test::Random& random, RefusedInput& input)
{
  const double spacing = random.uniform(0.7, 1.2);
  scanPart(*awkward::drawnPart(random, 0.6), spacing, spacing * random.uniform(0.15, 1.2), random, input);
}

/** Several holes, and settings for a part with one or none. */
void
holed(test::Random& random, RefusedInput& input)
{
  std::vector<test::PlaneLoop> loops{test::rectangle(60.0, 40.0)};
  for (const double x : {-18.0, 0.0, 18.0})
    if (random.below(4) > 0)
      loops.push_back(test::circle({x, random.uniform(-10.0, 10.0)}, random.uniform(2.5, 8.0)));
  scanPart(*test::flat(test::Region(loops)), random.uniform(0.7, 1.3), 0.0, random, input);
  switch (random.below(5)) {
  case 0:
    input.arguments = {"--method", "radial", "--hole-size", "4"};
    return;
  case 1:
    input.arguments = {"--holes", "refuse"};
    return;
  case 2:
    input.arguments = {"--hole-size", "4", "--rim", "inside,6"};
    return;
  case 3:
    input.arguments = {"--gaps", "refuse", "--hole-size", "12"};
    return;
  default:
    input.arguments = {"--method", "radial", "--hole-margin", "1", "--hole-size", "4"};
  }
}

using Maker = std::function<void(test::Random&, RefusedInput&)>;

Maker
scene(const char* kind)
{
  return [kind](test::Random& random, RefusedInput& input) { ofScene(kind, random, input); };
}

const std::map<std::string, Maker>&
makers()
{
  static const std::map<std::string, Maker> all{{"table", scene("table")},
                                                {"low", scene("low")},
                                                {"clamp", scene("clamp")},
                                                {"fillet", scene("fillet")},
                                                {"cluster", scene("cluster")},
                                                {"trees", scene("trees")},
                                                {"coarse", coarse},
                                                {"folded", folded},
                                                {"cropped", cropped},
                                                {"sheets", sheets},
                                                {"kept_out", keptOut},
                                                {"narrow", narrow},
                                                {"tight", tight},
                                                {"noisy", noisy},
                                                {"holed", holed}};
  return all;
}

} // namespace

std::vector<std::string>
kinds()
{
  std::vector<std::string> names;
  for (const auto& [name, make] : makers())
    names.push_back(name);
  return names;
}

RefusedInput
makeInput(const std::string& kind, std::uint64_t seed, std::uint64_t index)
{
  test::Random random(seed * 1000003 + index);
  RefusedInput input;
  makers().at(kind)(random, input);
  input.name = kind + " " + std::to_string(seed) + "/" + std::to_string(index);
  return input;
}

} // namespace pcl_spiral::followed
