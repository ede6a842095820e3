// SPDX-License-Identifier: BSD-3-Clause
#include "random_case.h"

#include "support/sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace pcl_spiral::acceptance {

namespace {

constexpr std::size_t fine = 512; ///< number of vertices of a round outline

/** An outline about 2 across, and its name. */
struct Outline {
  std::string name;
  std::vector<test::PlaneLoop> loops;
};

Outline
outline(test::Random& random)
{
  const double a = random.uniform(0.35, 1.0);
  switch (random.below(8)) {
  case 0:
    return {"disc", {test::circle({0, 0}, 1.0, fine)}};
  case 1:
    return {"ellipse", {test::ellipse(1.0, a, fine)}};
  case 2:
    return {"rectangle", {test::rectangle(2.0, 2.0 * a)}};
  case 3:
    return {"slot", {test::slot(2.0, 1.2 * a, fine)}};
  case 4:
    return {"star", {test::star(3 + static_cast<int>(random.below(5)), 1.0, random.uniform(0.45, 0.9))}};
  case 5:
    return {"ell", {test::ell(2.0, random.uniform(0.5, 1.4))}};
  case 6:
    return {"kidney", {test::kidney(1.0, random.uniform(0.4, 0.7), random.uniform(0.1, 0.9), fine)}};
  default: {
    const double hole = random.uniform(0.1, 0.6), off = random.uniform(0.0, 0.8 - hole);
    const double turn = random.uniform(0.0, 2.0 * M_PI);
    return {"ring", {test::circle({0, 0}, 1.0, fine), test::circle({off * std::cos(turn), off * std::sin(turn)}, hole, fine)}};
  }
  }
}

test::Region
scaled(const Outline& outline, double size)
{
  std::vector<test::PlaneLoop> loops = outline.loops;
  for (test::PlaneLoop& loop : loops)
    for (Eigen::Vector2d& u : loop)
      u *= size;
  return test::Region(loops);
}

std::pair<std::string, test::SurfacePtr>
surface(test::Random& random, const Outline& outline, double size)
{
  const test::Region region = scaled(outline, size);
  const auto radius = [&] { return size * std::pow(10.0, random.uniform(0.15, 1.5)); };
  const auto either = [&] { return random.uniform() < 0.5 ? -1.0 : 1.0; };
  switch (random.below(4)) {
  case 0:
    return {"flat", test::flat(region)};
  case 1:
    return {"ball", test::ball(1.6 * radius(), region)};
  case 2:
    return {"cylinder", test::cylinder(1.6 * radius(), region)};
  default:
    return {"quadric", test::quadric(either() * radius(), either() * radius(), region)};
  }
}

/** Curvatures at points over the whole surface. */
void
measureBend(RandomCase& made, const test::Sampled& scan)
{
  for (std::size_t i = 0; i < scan.points.size(); i += 7) {
    const auto [least, most] = made.surface->principalCurvatures(scan.points[i]);
    made.bend = std::max({made.bend, std::abs(least), std::abs(most)});
    made.concave = std::max(made.concave, -least);
  }
}

template <typename Enum>
Enum
choice(test::Random& random, std::initializer_list<Enum> values)
{
  return *(values.begin() + random.below(values.size()));
}

/** A cutter of a fiftieth to a third of the part, a few to sixty turns. */
void
chooseJob(test::Random& random, RandomCase& made, double size, const std::vector<Eigen::Vector3d>& points)
{
  SpiralSettings& s = made.settings;
  s.tool_radius = size * std::pow(10.0, random.uniform(-1.7, -0.4));
  const double step = size / random.uniform(3.0, 50.0);
  s.scallop_height = std::min(step * step / (8.0 * s.tool_radius), 0.4 * s.tool_radius);
  s.chord_error = s.scallop_height * random.uniform(0.1, 1.0);
  if (random.uniform() < 0.2)
    s.max_step = size * random.uniform(0.02, 0.5);
  s.tilt_angle = random.uniform() < 0.3 ? 0.0 : random.uniform(-40.0, 40.0);
  s.lead_angle = random.uniform() < 0.7 ? 0.0 : random.uniform(-20.0, 20.0);
  s.direction = choice(random, {SpiralDirection::Outward, SpiralDirection::Inward});
  s.sense = choice(random, {SpiralSense::Clockwise, SpiralSense::CounterClockwise});
  s.boundary_mode = choice(random, {BoundaryMode::Automatic, BoundaryMode::Automatic, BoundaryMode::Automatic, BoundaryMode::OneBoundary,
                                    BoundaryMode::TwoBoundaries});
  s.pitch = choice(random, {Pitch::AcrossFeed, Pitch::AcrossFeed, Pitch::AlongLine});
  s.lines = choice(random, {LineMethod::Automatic, LineMethod::Automatic, LineMethod::Geodesic, LineMethod::Harmonic});
  s.gaps = choice(random, {GapHandling::Bridge, GapHandling::Bridge, GapHandling::Refuse});
  if (random.uniform() < 0.1)
    s.centre = made.motion * points[random.below(points.size())];
  if (random.uniform() < 0.1)
    s.start_point = made.motion * points[random.below(points.size())];
  if (random.uniform() < 0.1)
    s.outlier_neighbours = 8 + static_cast<int>(random.below(16));
  if (random.uniform() < 0.1)
    s.thinning = made.spacing * random.uniform(0.2, 1.5);
  s.threads = 1; // on a busy computer several threads wait for each other, which is not a hang
}

/** Adds outliers, duplicates and non-finite points to the scan. */
void
spoil(test::Random& random, RandomCase& made, double size, std::vector<Eigen::Vector3d>& points)
{
  if (random.uniform() < 0.3) {
    made.outliers = static_cast<std::size_t>(0.02 * random.uniform() * static_cast<double>(points.size()));
    for (std::size_t i = 0; i < made.outliers; ++i)
      points.emplace_back(size * random.uniform(-1.5, 1.5), size * random.uniform(-1.5, 1.5), size * random.uniform(-1, 1));
  }
  if (random.uniform() < 0.2)
    for (std::size_t i = 0, n = points.size() / 20; i < n; ++i)
      points.push_back(points[random.below(n)]);
  if (random.uniform() < 0.2)
    for (int i = 0; i < 5; ++i)
      points.emplace_back(Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
}

std::string
inWords(const RandomCase& made, const std::string& surface, const std::string& outline, std::size_t points)
{
  const SpiralSettings& s = made.settings;
  std::ostringstream text;
  text << surface << ' ' << outline << ", " << points << " points " << made.spacing << " apart" << (made.even ? "" : " in lines")
       << ", noise " << made.noise << ", " << made.outliers << " outliers, bend " << made.bend << ", R " << s.tool_radius << ", scallop "
       << s.scallop_height << ", chord " << s.chord_error;
  return text.str();
}

} // namespace

RandomCase
randomCase(std::uint64_t seed, std::uint64_t index)
{
  const std::uint64_t own = seed * 1000003 + index;
  test::Random random(own);
  RandomCase made;
  const double size = 50.0 * std::pow(10.0, random.uniform(-1.0, 1.0));
  const Outline edge = outline(random);
  const auto [kind, piece] = surface(random, edge, size);
  made.surface = piece;
  const auto count = static_cast<std::size_t>(500.0 * std::pow(10.0, random.uniform()));
  made.spacing = std::sqrt(piece->area() / static_cast<double>(count));
  made.even = random.uniform() < 0.7;
  const double ratio = random.uniform(1.0, 4.0);
  test::Sampled scan = made.even ? test::sampleUniform(*piece, count, own)
                                 : test::sampleScanLines(*piece, made.spacing / std::sqrt(ratio), made.spacing * std::sqrt(ratio), own);
  measureBend(made, scan);
  if (random.uniform() < 0.5)
    made.noise = made.spacing * 0.2 * random.uniform();
  test::addNoise(scan, made.noise, own + 1);
  if (random.uniform() < 0.5)
    made.motion = test::randomMotion(own, 3.0 * size);
  spoil(random, made, size, scan.points);
  double top = 0.0; // a flat cap of a large ball is high
  for (const Eigen::Vector3d& p : scan.points)
    if (p.allFinite())
      top = std::max(top, p.z());
  made.settings.view_point = made.motion * Eigen::Vector3d(0.0, 0.0, top + 30.0 * size);
  chooseJob(random, made, size, scan.points);
  made.name = inWords(made, kind, edge.name, scan.points.size());
  for (Eigen::Vector3d& p : scan.points)
    p = made.motion * p;
  made.cloud = test::toCloud(scan.points);
  return made;
}

SpiralSettings
settingsOf(const RandomCase& random, SpiralMethod method)
{
  SpiralSettings settings = random.settings;
  settings.method = method;
  if (method == SpiralMethod::ConstantScallop) {
    settings.centre.reset();
    settings.lines = SpiralSettings().lines;
    settings.pitch = SpiralSettings().pitch;
  }
  return settings;
}

} // namespace pcl_spiral::acceptance
