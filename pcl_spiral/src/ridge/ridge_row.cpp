// SPDX-License-Identifier: BSD-3-Clause
#include "ridge_row.h"

#include "core/tilted_axes.h"

#include <pcl_spiral/core/impl/angles.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

/** Places of the surface along the parameter of a row. */
class Row {
public:
  Row(const RidgeSurface& surface, const RidgeRowSettings& settings, double place)
  : surface_(surface), settings_(settings), along_rail_(settings.direction == RidgeDirection::AlongRail), place_(place)
  {}

  bool closed() const { return line().closed(); }
  Vector3d at(double t) const { return along_rail_ ? surface_.position(t, place_) : surface_.position(place_, t); }

  Vector3d normalAt(double t) const
  {
    return along_rail_ ? surface_.normal(t, place_, settings_.normals) : surface_.normal(place_, t, settings_.normals);
  }

  /** Parameters of the points, without the last of a closed row: as many as the spacing and the chord error need. */
  std::vector<double> parameters() const
  {
    constexpr int most_rounds = 5;
    constexpr double more = 1.05, most = 1e6;
    const bool equal = settings_.steps == RidgeSteps::EqualOnRow;
    const Ways ways = equal ? measured() : Ways{{0.0, line().length()}, {0.0, line().length()}};
    double count = std::max(closed() ? 3.0 : 1.0, std::ceil(ways.sums.back() / settings_.point_spacing - 1e-9));
    std::vector<double> result = spread(ways, static_cast<int>(count));
    for (int round = 0; equal && settings_.chord_error > 0.0 && round < most_rounds; ++round) {
      const double error = largestError(result);
      if (error <= settings_.chord_error || count >= most)
        break;
      count = std::min(most, std::ceil(count * more * std::sqrt(error / settings_.chord_error)));
      result = spread(ways, static_cast<int>(count));
    }
    return result;
  }

private:
  /** Lengths of the row up to closely spaced parameters. */
  struct Ways {
    std::vector<double> parameters, sums;
  };

  const SmoothLine& line() const { return along_rail_ ? surface_.rail() : surface_.generator(); }

  Ways measured() const
  {
    constexpr double parts = 8.0; // of a step: the row is replaced by chords
    Ways ways{{0.0}, {0.0}};
    const double length = line().length();
    const int pieces = static_cast<int>(std::ceil(parts * length / settings_.point_spacing)) + 8;
    Vector3d before = at(0.0);
    for (int k = 1; k <= pieces; ++k) {
      ways.parameters.push_back(length * k / pieces);
      const Vector3d next = at(ways.parameters.back());
      ways.sums.push_back(ways.sums.back() + (next - before).norm());
      before = next;
    }
    return ways;
  }

  /** Parameters at equal steps of the length. */
  std::vector<double> spread(const Ways& ways, int count) const
  {
    std::vector<double> result;
    std::size_t piece = 1;
    for (int k = 0; k < count + (closed() ? 0 : 1); ++k) {
      const double way = ways.sums.back() * k / count;
      while (piece + 1 < ways.sums.size() && ways.sums[piece] < way)
        ++piece;
      const double share = (way - ways.sums[piece - 1]) / (ways.sums[piece] - ways.sums[piece - 1]);
      result.push_back(ways.parameters[piece - 1] + (ways.parameters[piece] - ways.parameters[piece - 1]) * share);
    }
    return result;
  }

  /** Largest distance, half way, of straight moves of contact and tool from the row. */
  double largestError(const std::vector<double>& places) const
  {
    double largest = 0.0;
    const auto off = [](const Vector3d& a, const Vector3d& b, const Vector3d& p) { // p from the line through a and b
      const Vector3d way = b - a;
      return way.norm() > 0.0 ? way.cross(p - a).norm() / way.norm() : (p - a).norm();
    };
    Vector3d contact = at(places.front()), tip = contact + settings_.stand_off * normalAt(places.front());
    for (std::size_t i = 1; i < places.size(); ++i) {
      const double middle = 0.5 * (places[i - 1] + places[i]);
      const Vector3d next = at(places[i]), next_tip = next + settings_.stand_off * normalAt(places[i]);
      const Vector3d between = at(middle);
      largest = std::max({largest, off(contact, next, between), off(tip, next_tip, between + settings_.stand_off * normalAt(middle))});
      contact = next;
      tip = next_tip;
    }
    return largest;
  }

  const RidgeSurface& surface_;
  const RidgeRowSettings& settings_;
  bool along_rail_;
  double place_;
};

/** Axes from the travel of the contacts; on a ring the first and last point are neighbours. */
std::vector<Vector3d>
axesOf(Polyline contacts, std::vector<Vector3d> normals, bool closed, const RidgeRowSettings& settings)
{
  if (closed) {
    contacts.insert(contacts.begin(), contacts.back());
    normals.insert(normals.begin(), normals.back());
    contacts.push_back(contacts[1]);
    normals.push_back(normals[1]);
  }
  std::vector<Vector3d> axes = tiltedAxes(contacts, normals, settings.tilt * degree, settings.lead * degree);
  if (closed) {
    axes.erase(axes.begin());
    axes.pop_back();
  }
  return axes;
}

/** Continue straight beyond the last contact by \p length. */
void
addRun(double length, double spacing, Polyline& contacts, std::vector<Vector3d>& normals)
{
  const Vector3d end = contacts.back(), way = (end - contacts[contacts.size() - 2]).normalized(), normal = normals.back();
  const int steps = static_cast<int>(std::ceil(length / spacing - 1e-9));
  for (int k = 1; k <= steps; ++k) {
    contacts.push_back(end + way * (length * k / steps));
    normals.push_back(normal);
  }
}

} // namespace

RidgeRow
ridgeRow(const RidgeSurface& surface, const RidgeRowSettings& settings, double place, bool turned)
{
  const Row row(surface, settings, place);
  RidgeRow result;
  result.pass.closed = row.closed();
  std::vector<double> parameters = row.parameters();
  if (turned)
    std::reverse(parameters.begin() + (row.closed() ? 1 : 0), parameters.end());
  Polyline contacts;
  std::vector<Vector3d> normals;
  for (const double t : parameters) {
    contacts.push_back(row.at(t));
    normals.push_back(row.normalAt(t));
  }
  if (!row.closed())
    for (const double length : {settings.run_out, settings.run_in}) { // each reverses the row, so in the end the run-in comes first
      addRun(length, settings.point_spacing, contacts, normals);
      std::reverse(contacts.begin(), contacts.end());
      std::reverse(normals.begin(), normals.end());
    }
  const std::vector<Vector3d> axes = axesOf(contacts, normals, row.closed(), settings);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    result.pass.points.push_back({contacts[i] + settings.stand_off * normals[i], axes[i], normals[i]});
    if (i > 0 && !result.backwards &&
        (result.pass.points[i].position - result.pass.points[i - 1].position).dot(contacts[i] - contacts[i - 1]) <= 0.0)
      result.backwards = contacts[i];
  }
  return result;
}

} // namespace pcl_spiral
