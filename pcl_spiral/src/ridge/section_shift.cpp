// SPDX-License-Identifier: BSD-3-Clause
#include "section_shift.h"

#include "core/median.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/** A point relative to the shifted generator. */
struct Residual {
  double off = 0.0;    ///< distance, positive on the outer side
  Vector2d normal;     ///< of the generator, along chord and up
  double turned = 0.0; ///< its move along the normal if the section turns by one radian
  std::size_t cell = 0;
  bool within = false; ///< within the length of the generator
};

std::vector<Residual>
residualsOf(SectionBand& band, const SectionPoints& sections, std::size_t section, const Profile& profile, const Vector3d& shift,
            double gate)
{
  std::vector<Residual> residuals;
  for (std::uint32_t n = sections.begin[section]; n < sections.begin[section + 1]; ++n) {
    BandPoint& point = band.points[sections.order[n]];
    const Vector3d q(0.0, point.local.y() - shift.y(), point.local.z() - shift.z());
    const LineFoot foot = profile.line.foot(q, point.profile_station);
    if (!foot.inside)
      continue;
    Residual r;
    r.normal = Vector2d(-foot.tangent.z(), foot.tangent.y());
    r.off = (q - foot.position).tail<2>().dot(r.normal);
    if (std::abs(r.off) > gate)
      continue;
    r.turned = r.normal.dot(Vector2d(-point.local.z(), point.local.y()));
    r.cell = static_cast<std::size_t>((foot.s - profile.line.s(0)) / profile.line.step() + 0.5);
    r.within = foot.s >= 0.0 && foot.s <= profile.length;
    residuals.push_back(r);
  }
  return residuals;
}

/** Where Tukey's weights end: 4.685 standard deviations, from the median distance, but at least the noise. */
double
cutOf(const std::vector<Residual>& residuals, double noise)
{
  std::vector<double> off;
  for (const Residual& r : residuals)
    if (r.within)
      off.push_back(std::abs(r.off));
  return 4.685 * std::max(noise, off.empty() ? 0.0 : 1.4826 * medianOf(off));
}

double
weightOf(double off, double cut)
{
  const double share = off / cut;
  return std::abs(share) < 1.0 ? (1.0 - share * share) * (1.0 - share * share) : 0.0;
}

/** The Gauss-Newton step, and the step for a roll; false if the normals define only one direction. */
bool
stepOf(const std::vector<Residual>& residuals, double cut, Vector2d& step, Vector2d& roll)
{
  constexpr double least_spread = 7e-4; // of the normals, squared: 1.5 degrees
  constexpr double fewest = 8.0;
  Eigen::Matrix2d a = Eigen::Matrix2d::Zero();
  Vector2d right = Vector2d::Zero(), turned = Vector2d::Zero();
  double weights = 0.0;
  for (const Residual& r : residuals)
    if (r.within) {
      const double w = weightOf(r.off, cut);
      a += w * r.normal * r.normal.transpose();
      right += w * r.off * r.normal;
      turned += w * r.turned * r.normal;
      weights += w;
    }
  if (weights < fewest || Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(a).eigenvalues()[0] < least_spread * weights)
    return false;
  step = a.inverse() * right;
  roll = a.inverse() * turned;
  return true;
}

void
sumCells(const std::vector<Residual>& residuals, double cut, std::size_t cells, SectionShift& result)
{
  std::vector<std::vector<double>> off(cells);
  std::vector<double> sum(cells, 0.0), weight(cells, 0.0);
  result.mean.assign(cells, 0.0f);
  result.median.assign(cells, 0.0f);
  result.count.assign(cells, 0);
  for (const Residual& r : residuals) {
    const double w = weightOf(r.off, cut);
    off[r.cell].push_back(r.off);
    sum[r.cell] += w * r.off;
    weight[r.cell] += w;
    ++result.count[r.cell];
    if (r.within) {
      result.squares += r.off * r.off;
      ++result.points;
    }
  }
  for (std::size_t k = 0; k < cells; ++k)
    if (result.count[k] > 0) {
      result.median[k] = static_cast<float>(medianOf(off[k]));
      result.mean[k] = weight[k] > 0.0 ? static_cast<float>(sum[k] / weight[k]) : result.median[k];
    }
}

} // namespace

SectionShift
shiftOnto(SectionBand& band, const SectionPoints& sections, std::size_t section, const Profile& profile, double noise, double gate,
          int most_steps)
{
  constexpr double still = 1e-3; // of the noise
  SectionShift result;
  std::vector<Residual> residuals = residualsOf(band, sections, section, profile, result.shift, gate);
  for (int i = 0; i < most_steps; ++i) {
    Vector2d step, roll;
    result.found = stepOf(residuals, cutOf(residuals, noise), step, roll) && step.norm() < gate;
    if (!result.found)
      break;
    result.shift.tail<2>() += step;
    result.roll.tail<2>() = roll;
    residuals = residualsOf(band, sections, section, profile, result.shift, gate);
    if (step.norm() < still * noise)
      break;
  }
  sumCells(residuals, cutOf(residuals, noise), profile.line.size(), result);
  return result;
}

} // namespace pcl_spiral
