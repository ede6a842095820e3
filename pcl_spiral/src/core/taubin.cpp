// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/core/polyline.h>

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pcl_spiral {

namespace {

using Eigen::Vector3d;
using Index = std::ptrdiff_t;
constexpr int fine_passes = 2;

void
check(const TaubinOptions& o)
{
  if (!(o.wavelength > 0.0) || !std::isfinite(o.wavelength))
    throw std::invalid_argument("taubinSmoothed: the wavelength must be above 0");
  if (!(o.lambda > 0.0 && o.lambda <= 1.0) || !(o.mu <= -o.lambda && o.mu >= -1.2))
    throw std::invalid_argument("taubinSmoothed: set 0 < lambda <= 1 and -1.2 <= mu <= -lambda");
  const double k = 1.0 - std::cos(1.0);
  if ((1.0 - o.lambda * k) * (1.0 - o.mu * k) >= 0.995)
    throw std::invalid_argument("taubinSmoothed: lambda and mu do not smooth this wavelength away; bring mu nearer to -lambda");
}

/** Sampling, stride and passes for a stretch of line. */
struct Plan {
  std::size_t samples = 0; ///< intervals
  Index stride = 1;
  int passes = 1;
};

double
passGain(double phase, const TaubinOptions& o)
{
  const double k = 1.0 - std::cos(phase);
  return (1.0 - o.lambda * k) * (1.0 - o.mu * k);
}

/** Strides before the last one, ascending: 1 .. M/4, M/2, rounded up. */
std::vector<Index>
fineStrides(Index stride)
{
  std::vector<Index> strides;
  while (stride > 1)
    strides.push_back(stride = (stride + 1) / 2);
  return {strides.rbegin(), strides.rend()};
}

Plan
plan(double length, double mean_spacing, const TaubinOptions& o)
{
  Plan p;
  p.stride = std::max<Index>(1, static_cast<Index>(std::ceil(o.wavelength / (2.0 * pi * mean_spacing))));
  const double spacing = o.wavelength / (2.0 * pi * static_cast<double>(p.stride));
  p.samples = static_cast<std::size_t>(std::ceil(length / spacing));
  p.stride = std::min(p.stride, static_cast<Index>(p.samples));
  p.passes = std::max(1, static_cast<int>(std::lround(std::log(0.5) / std::log(passGain(1.0, o)))));
  return p;
}

/** Piecewise cubic through values at ascending parameters; tangents from the parabola through three neighbours.
 */
class Interpolant {
public:
  /** \param s one parameter per value; when closed one more, the period. */
  Interpolant(const std::vector<double>& s, const Polyline& values, bool closed) : s_(s), values_(values)
  {
    const std::size_t n = values.size(), pieces = s.size() - 1;
    std::vector<Vector3d> slope(pieces);
    for (std::size_t i = 0; i < pieces; ++i) {
      const double h = s[i + 1] - s[i];
      slope[i] = h > 0.0 ? Vector3d((values[(i + 1) % n] - values[i]) / h) : Vector3d(Vector3d::Zero());
    }
    tangents_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t before = i ? i - 1 : closed ? pieces - 1 : 0, after = std::min(i, pieces - 1);
      const double f = s[before + 1] - s[before], g = s[after + 1] - s[after];
      tangents_[i] = f + g > 0.0 ? Vector3d((g * slope[before] + f * slope[after]) / (f + g)) : slope[before];
    }
    if (!closed && pieces > 1) { // the slopes at the ends of the parabola
      tangents_.front() = 2.0 * slope.front() - tangents_[1];
      tangents_.back() = 2.0 * slope.back() - tangents_[n - 2];
    }
  }

  /** \param piece where to start looking; moves on with ascending \p at. */
  Vector3d operator()(double at, std::size_t& piece) const
  {
    while (piece + 2 < s_.size() && s_[piece + 1] < at)
      ++piece;
    const std::size_t next = (piece + 1) % values_.size();
    const double h = s_[piece + 1] - s_[piece];
    if (!(h > 0.0))
      return values_[piece];
    const double t = std::clamp((at - s_[piece]) / h, 0.0, 1.0), r = 1.0 - t;
    return r * r * (1.0 + 2.0 * t) * values_[piece] + t * t * (1.0 + 2.0 * r) * values_[next] +
           h * t * r * (r * tangents_[piece] - t * tangents_[next]);
  }

private:
  const std::vector<double>& s_;
  const Polyline& values_;
  std::vector<Vector3d> tangents_;
};

/** One step p += factor L p with the neighbours \p stride samples away. Open lines have n + 1 samples, closed ones n.
 */
void
step(Polyline& p, Polyline& next, Index stride, double factor, bool closed, int threads)
{
  const Index n = static_cast<Index>(p.size()), last = n - 1;
#pragma omp parallel for num_threads(threads) schedule(static) if (n > 20000)
  for (Index i = 0; i < n; ++i) {
    Index before = i - stride, after = i + stride;
    Vector3d low, high;
    if (closed) {
      low = p[static_cast<std::size_t>((before % n + n) % n)];
      high = p[static_cast<std::size_t>(after % n)];
    }
    else {
      low = before >= 0 ? p[before] : Vector3d(2.0 * p[0] - p[-before]);
      high = after <= last ? p[after] : Vector3d(2.0 * p[last] - p[2 * last - after]);
    }
    next[i] = p[i] + factor * (0.5 * (low + high) - p[i]);
  }
  if (!closed) {
    next.front() = p.front();
    next.back() = p.back();
  }
  p.swap(next);
}

/** Smooth one stretch: an open line with fixed ends, or a closed one. */
Polyline
smoothStretch(const Polyline& line, const TaubinOptions& o, bool closed)
{
  const std::vector<double> s = arcLengths(line, closed);
  const double mean_spacing = s.back() / static_cast<double>(s.size() - 1);
  if (line.size() < 3 || !(o.wavelength >= 2.0 * mean_spacing) || !(mean_spacing > 0.0))
    return line;
  const Plan p = plan(s.back(), mean_spacing, o);
  std::vector<double> at(p.samples + 1);
  for (std::size_t i = 0; i <= p.samples; ++i)
    at[i] = s.back() * static_cast<double>(i) / static_cast<double>(p.samples);
  Polyline sampled(closed ? p.samples : p.samples + 1), buffer(sampled.size());
  const Interpolant given(s, line, closed);
  std::size_t piece = 0;
  for (std::size_t i = 0; i < sampled.size(); ++i)
    sampled[i] = given(at[i], piece);
  const int threads = o.threads > 0 ? static_cast<int>(o.threads) : omp_get_max_threads();
  auto pass = [&](Index stride) {
    step(sampled, buffer, stride, o.lambda, closed, threads);
    step(sampled, buffer, stride, o.mu, closed, threads);
  };
  for (Index stride : fineStrides(p.stride))
    for (int i = 0; i < fine_passes; ++i)
      pass(stride);
  for (int i = 0; i < p.passes; ++i)
    pass(p.stride);
  const Interpolant smooth(at, sampled, closed);
  Polyline result(line.size());
  piece = 0;
  for (std::size_t i = 0; i < line.size(); ++i)
    result[i] = smooth(s[i], piece);
  if (!closed) {
    result.front() = line.front();
    result.back() = line.back();
  }
  return result;
}

} // namespace

Polyline
taubinSmoothed(const Polyline& line, const TaubinOptions& options)
{
  check(options);
  const std::size_t n = line.size();
  std::vector<std::size_t> pins = options.pinned;
  if (!options.closed && n > 0)
    pins.insert(pins.end(), {0, n - 1});
  std::sort(pins.begin(), pins.end());
  pins.erase(std::unique(pins.begin(), pins.end()), pins.end());
  if (!pins.empty() && n > 0 && pins.back() >= n)
    throw std::invalid_argument("taubinSmoothed: a pinned point is not on the line");
  if (n < 3)
    return line;
  if (pins.empty())
    return smoothStretch(line, options, true);
  if (options.closed)
    pins.push_back(pins.front() + n);
  Polyline result = line;
  for (std::size_t k = 0; k + 1 < pins.size(); ++k) {
    Polyline stretch;
    for (std::size_t i = pins[k]; i <= pins[k + 1]; ++i)
      stretch.push_back(line[i % n]);
    stretch = smoothStretch(stretch, options, false);
    for (std::size_t i = pins[k] + 1; i < pins[k + 1]; ++i)
      result[i % n] = stretch[i - pins[k]];
  }
  return result;
}

double
taubinGain(double wave_length, double spacing, const TaubinOptions& options)
{
  check(options);
  if (!(options.wavelength >= 2.0 * spacing))
    return 1.0;
  const Plan p = plan(1e6 * options.wavelength, spacing, options);
  const double phase = options.wavelength / wave_length; // of the last stride
  double gain = std::pow(passGain(phase, options), p.passes);
  for (Index stride : fineStrides(p.stride))
    gain *= std::pow(passGain(phase * static_cast<double>(stride) / static_cast<double>(p.stride), options), fine_passes);
  return gain;
}

} // namespace pcl_spiral
