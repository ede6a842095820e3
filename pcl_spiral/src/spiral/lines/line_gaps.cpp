// SPDX-License-Identifier: BSD-3-Clause
#include "line_gaps.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr int coarse_lines = 32;

} // namespace

std::vector<LinePlace>
coarsePlaces(const RimCurve& rim)
{
  std::vector<double> stops{0.0};
  std::vector<bool> is_corner{!rim.corners().empty() && rim.corners()[0] == 0};
  for (const std::size_t k : rim.corners())
    if (k != 0) {
      stops.push_back(rim.arcLengthOf(k));
      is_corner.push_back(true);
    }
  stops.push_back(rim.length());
  std::vector<LinePlace> places;
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
    const double span = stops[i + 1] - stops[i];
    const int pieces = std::max(1, static_cast<int>(std::lround(coarse_lines * span / rim.length())));
    for (int p = 0; p < pieces; ++p)
      places.push_back({stops[i] + span * p / pieces, p == 0 && is_corner[i], 0});
  }
  return places;
}

LineGap::LineGap(const std::vector<LinePlace>& places, const RimCurve& rim, std::size_t i)
{
  const std::size_t n = places.size();
  const double whole = rim.length(), end = i + 1 < n ? places[i + 1].s : whole;
  lines_ = {i, (i + 1) % n};
  s_ = {places[i].s, end};
  if (!places[i].corner && n > 3) {
    lines_.insert(lines_.begin(), (i + n - 1) % n);
    s_.insert(s_.begin(), i > 0 ? places[i - 1].s : places[n - 1].s - whole);
  }
  if (!places[(i + 1) % n].corner && n > 3) {
    lines_.push_back((i + 2) % n);
    s_.push_back(places[(i + 2) % n].s + (i + 2 >= n ? whole : 0.0));
  }
  begin_ = places[i].s;
  width_ = end - begin_;
  middle_ = begin_ + 0.5 * width_;
}

std::vector<double>
LineGap::weights(double s) const
{
  std::vector<double> result(s_.size(), 1.0);
  for (std::size_t a = 0; a < s_.size(); ++a)
    for (std::size_t b = 0; b < s_.size(); ++b)
      if (a != b)
        result[a] *= (s - s_[b]) / (s_[a] - s_[b]);
  return result;
}

Eigen::Vector3d
LineGap::predictedAt(const std::vector<RadialLine>& lines, const std::vector<double>& weights, std::size_t station) const
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t a = 0; a < lines_.size(); ++a)
    sum += weights[a] * lines[lines_[a]].feet[station].position;
  return sum;
}

double
LineGap::rimError(const RimCurve& rim) const
{
  double largest = 0.0;
  for (const double share : {0.25, 0.5, 0.75}) {
    const double s = begin_ + share * width_;
    const std::vector<double> weight = weights(s);
    Eigen::Vector3d error = -rim.at(s);
    for (std::size_t a = 0; a < s_.size(); ++a)
      error += weight[a] * rim.at(s_[a] < 0.0 ? s_[a] + rim.length() : std::fmod(s_[a], rim.length()));
    largest = std::max(largest, error.norm());
  }
  return largest;
}

Polyline
LineGap::predicted(const std::vector<RadialLine>& lines, const RimCurve& rim) const
{
  const std::vector<double> weight = weights(middle_);
  const auto& first = lines[lines_[0]].feet;
  Polyline line;
  for (std::size_t station = 0; station < first.size(); ++station)
    line.push_back(predictedAt(lines, weight, station));
  line.front() = first.front().position;
  const Eigen::Vector3d amiss = rim.at(middle_) - line.back();
  for (std::size_t station = 1; station < line.size(); ++station)
    line[station] += static_cast<double>(station) / static_cast<double>(line.size() - 1) * amiss;
  return line;
}

double
LineGap::surprise(const std::vector<RadialLine>& lines, const RadialLine& found, double& misfit) const
{
  const std::vector<double> weight = weights(middle_);
  const std::size_t last = found.feet.size() - 1;
  const auto error = [&](std::size_t station) {
    return Eigen::Vector3d(predictedAt(lines, weight, station) - found.feet[station].position);
  };
  const Eigen::Vector3d of_rim = error(last);
  double largest = of_rim.norm();
  misfit = 0.0;
  for (const std::size_t quarter : {1, 2, 3}) {
    const Eigen::Vector3d here = error(quarter * last / 4);
    largest = std::max(largest, here.norm());
    misfit = std::max(misfit, (here - 0.25 * static_cast<double>(quarter) * of_rim).norm());
  }
  return largest;
}

} // namespace pcl_spiral
