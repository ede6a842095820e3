// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/core/polyline.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <random>

namespace taubin_test {

using namespace pcl_spiral;
using Eigen::Vector3d;

namespace {

constexpr double pi = 3.14159265358979323846;

/** Straight line along x with a small wave in z. */
Polyline
wave(double length, double spacing, double wave_length, double height)
{
  Polyline line;
  const auto n = static_cast<std::size_t>(std::lround(length / spacing));
  for (std::size_t i = 0; i <= n; ++i) {
    const double x = length * static_cast<double>(i) / static_cast<double>(n);
    line.emplace_back(x, 0.0, height * std::sin(2 * pi * x / wave_length));
  }
  return line;
}

/** Amplitude of the wave in the middle half of the line, by projection on sine and cosine. */
double
amplitude(const Polyline& line, double wave_length)
{
  const double length = line.back().x(), periods = std::floor(0.5 * length / wave_length);
  const double from = 0.25 * length, to = from + periods * wave_length;
  double a = 0.0, b = 0.0, n = 0.0;
  for (const Vector3d& p : line)
    if (p.x() >= from && p.x() < to) {
      a += p.z() * std::sin(2 * pi * p.x() / wave_length);
      b += p.z() * std::cos(2 * pi * p.x() / wave_length);
      n += 0.5;
    }
  return std::hypot(a, b) / n;
}

double
measuredGain(double spacing, double wave_length, const TaubinOptions& options)
{
  const double height = 1e-4;
  return amplitude(taubinSmoothed(wave(600, spacing, wave_length, height), options), wave_length) / height;
}

Polyline
circle(double radius, std::size_t n)
{
  Polyline line(n);
  for (std::size_t i = 0; i < n; ++i)
    line[i] = radius * Vector3d(std::cos(2 * pi * i / n), std::sin(2 * pi * i / n), 0.0);
  return line;
}

} // namespace

TEST(Taubin, GainsByWavelengthWhateverTheSpacing)
{
  TaubinOptions options;
  options.wavelength = 10.0;
  for (double spacing : {0.1, 0.25, 0.5, 1.0}) {
    EXPECT_NEAR(measuredGain(spacing, 10.0, options), 0.5, 0.01) << spacing;
    EXPECT_LT(measuredGain(spacing, 5.0, options), 0.002) << spacing;
    EXPECT_NEAR(measuredGain(spacing, 15.0, options), 0.91, 0.015) << spacing;
    EXPECT_NEAR(measuredGain(spacing, 20.0, options), 1.0, 0.01) << spacing;
    EXPECT_NEAR(measuredGain(spacing, 30.0, options), 1.01, 0.01) << spacing;
    EXPECT_NEAR(measuredGain(spacing, 150.0, options), 1.0, 0.003) << spacing;
  }
}

TEST(Taubin, TransferFunctionIsTheDocumentedOne)
{
  TaubinOptions options;
  options.wavelength = 12.0;
  for (double spacing : {0.2, 0.5})
    for (double w : {6.0, 8.0, 10.0, 12.0, 15.0, 18.75, 30.0, 75.0})
      EXPECT_NEAR(measuredGain(spacing, w, options), taubinGain(w, spacing, options), 0.004) << spacing << ' ' << w;
}

TEST(Taubin, NoShortWaveGetsThrough)
{
  TaubinOptions options;
  options.wavelength = 10.0;
  for (double w = 0.45; w < 6.0; w *= 1.07) // the last stride only would let 1.6 mm, 0.8 mm ... pass
    EXPECT_LT(measuredGain(0.1, w, options), 0.03) << w;
}

TEST(Taubin, NoiseGoesTheShapeStays)
{
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 0.02);
  Polyline line = circle(100.0, 1256);
  for (Vector3d& p : line)
    p += Vector3d(noise(random), noise(random), noise(random));
  TaubinOptions options;
  options.wavelength = 10.0;
  options.closed = true;
  double rms = 0.0, mean = 0.0;
  for (const Vector3d& p : taubinSmoothed(line, options)) {
    const double error = std::hypot(p.x(), p.y()) - 100.0;
    rms += error * error + p.z() * p.z();
    mean += error;
  }
  EXPECT_LT(std::sqrt(rms / (2.0 * line.size())), 0.010);
  EXPECT_NEAR(mean / line.size(), 0.0, 0.008);
}

TEST(Taubin, CircleDoesNotShrink)
{
  TaubinOptions options;
  options.wavelength = 5.0;
  options.closed = true;
  for (std::size_t n : {180u, 629u, 2000u})
    for (const Vector3d& p : taubinSmoothed(circle(100.0, n), options)) {
      EXPECT_GE(p.norm(), 100.0 - 1e-4);
      EXPECT_LE(p.norm(), 100.0 + 0.0025); // grows by N |mu + lambda| (M d)^2 / 2R
    }
}

TEST(Taubin, EndsAndPinsAreExact)
{
  std::mt19937 random(9);
  std::normal_distribution<double> noise(0.0, 0.1);
  Polyline line = wave(100, 0.5, 23.0, 2.0);
  for (Vector3d& p : line)
    p.z() += noise(random);
  TaubinOptions options;
  options.wavelength = 6.0;
  options.pinned = {120, 40};
  const Polyline smooth = taubinSmoothed(line, options);
  ASSERT_EQ(smooth.size(), line.size());
  for (std::size_t i : {std::size_t(0), std::size_t(40), std::size_t(120), line.size() - 1})
    EXPECT_EQ(smooth[i], line[i]);
  EXPECT_NE(smooth[41], line[41]);
  options.closed = true;
  const Polyline ring = taubinSmoothed(line, options);
  EXPECT_EQ(ring[40], line[40]);
  EXPECT_EQ(ring[120], line[120]);
  EXPECT_NE(ring[0], line[0]);
}

TEST(Taubin, PinnedCornerStaysSharp)
{
  Polyline square;
  for (int side = 0; side < 4; ++side)
    for (int i = 0; i < 40; ++i) {
      const double a = 0.5 * pi * side, t = i - 20.0;
      square.emplace_back(20 * std::cos(a) - t * std::sin(a), 20 * std::sin(a) + t * std::cos(a), 0.0);
    }
  TaubinOptions options;
  options.closed = true;
  options.wavelength = 8.0;
  const Polyline rounded = taubinSmoothed(square, options);
  EXPECT_GT((rounded[0] - square[0]).norm(), 0.1);
  options.pinned = {0, 40, 80, 120};
  const Polyline sharp = taubinSmoothed(square, options);
  for (std::size_t i = 0; i < square.size(); ++i)
    EXPECT_LT((sharp[i] - square[i]).norm(), 1e-12);
}

TEST(Taubin, UnevenSpacingIsNoShape)
{
  Polyline line; // a straight line does not change
  for (double x = 0.0; x < 100.0; x += 0.2 + 0.8 * std::abs(std::sin(x)))
    line.emplace_back(x, 2.0 * x, -x);
  TaubinOptions options;
  options.wavelength = 10.0;
  const Polyline smooth = taubinSmoothed(line, options);
  for (std::size_t i = 0; i < line.size(); ++i)
    EXPECT_LT((smooth[i] - line[i]).norm(), 1e-10);
  Polyline coarse_then_fine = wave(300, 0.25, 10.0, 1e-4), thinned;
  for (std::size_t i = 0; i < coarse_then_fine.size(); ++i)
    if (i > 600 || i % 4 == 0)
      thinned.push_back(coarse_then_fine[i]);
  const Polyline half = taubinSmoothed(thinned, options);
  double fine = 0.0, coarse = 0.0;
  for (const Vector3d& p : half) {
    if (p.x() > 30 && p.x() < 130)
      coarse = std::max(coarse, std::abs(p.z()));
    if (p.x() > 170 && p.x() < 270)
      fine = std::max(fine, std::abs(p.z()));
  }
  EXPECT_NEAR(fine, 0.5e-4, 2e-6);
  EXPECT_NEAR(coarse, 0.5e-4, 3e-6);
}

TEST(Taubin, OneThreadOrMore)
{
  Polyline line = circle(100.0, 60001);
  for (std::size_t i = 0; i < line.size(); i += 3)
    line[i] *= 1.0001;
  TaubinOptions options;
  options.wavelength = 1.0;
  options.threads = 1;
  const Polyline one = taubinSmoothed(line, options);
  options.threads = 2;
  EXPECT_EQ(taubinSmoothed(line, options), one);
}

/** Threads of this process. */
std::size_t
threadsAlive()
{
  const std::filesystem::directory_iterator all("/proc/self/task");
  return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

TEST(Taubin, StartsNoMoreThreadsThanALimitLeaves)
{
  testing::FLAGS_gtest_death_test_style = "threadsafe"; // in a separate process that has not started threads yet
  const auto smooth = [] {
    const std::size_t before = threadsAlive();
    const pcl_spiral::ThreadLimit one(1);
    TaubinOptions options;
    options.wavelength = 1.0;
    taubinSmoothed(circle(100.0, 60001), options);
    std::exit(threadsAlive() == before ? 0 : 1);
  };
  EXPECT_EXIT(smooth(), testing::ExitedWithCode(0), "");
}

TEST(Taubin, TooLittleToSmoothAndBadOptions)
{
  TaubinOptions options;
  options.wavelength = 0.5;
  const Polyline line = wave(50, 1.0, 7.0, 1.0);
  EXPECT_EQ(taubinSmoothed(line, options), line);
  EXPECT_EQ(taubinGain(7.0, 1.0, options), 1.0);
  EXPECT_TRUE(taubinSmoothed({}, options).empty());
  EXPECT_EQ(taubinSmoothed({Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()}, options).size(), 3u);
  options.wavelength = 0.0;
  EXPECT_THROW(taubinSmoothed(line, options), std::invalid_argument);
  options = TaubinOptions();
  options.mu = -0.4;
  EXPECT_THROW(taubinSmoothed(line, options), std::invalid_argument);
  options.mu = -0.9;
  EXPECT_THROW(taubinSmoothed(line, options), std::invalid_argument) << "lets the wavelength pass";
  options = TaubinOptions();
  options.pinned = {1000};
  EXPECT_THROW(taubinSmoothed(line, options), std::invalid_argument);
}

} // namespace taubin_test
