// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/core/impl/angles.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace pcl_spiral {
namespace {

constexpr double rounding = 1e-9;       // of R: a flat radius smaller than this, of either sign, counts as 0
constexpr double angle_rounding = 1e-6; // radians: axes and normals often come in single precision
constexpr double steepest_angle = 89.9; // degrees, of a flank
constexpr double largest_radius = 1e6;  // mm

Diagnostic
faultText(const char* what, double value, const char* remedy)
{
  return Diagnostic(what, " ", value, remedy);
}

double
flankRadiusOf(const CutterShape& s)
{
  return s.radius - s.flank_length * std::sin(s.flank_angle * degree);
}

double
flatRadiusOf(const CutterShape& s)
{
  return flankRadiusOf(s) - s.corner_radius * std::cos(s.flank_angle * degree);
}

} // namespace

CutterShape
CutterShape::ball(double radius, double flank_length)
{
  return {radius, radius, flank_length, 0.0};
}

CutterShape
CutterShape::flatEnd(double radius, double flank_length)
{
  return {radius, 0.0, flank_length, 0.0};
}

CutterShape
CutterShape::bullNose(double radius, double corner_radius, double flank_length)
{
  return {radius, corner_radius, flank_length, 0.0};
}

CutterShape
CutterShape::taper(double radius, double flank_length, double flank_angle)
{
  return {radius, 0.0, flank_length, flank_angle};
}

CutterShape
CutterShape::taperedBall(double radius, double flank_length, double flank_angle)
{
  const CutterShape cone{radius, 0.0, flank_length, flank_angle};
  return {radius, flankRadiusOf(cone) / std::cos(flank_angle * degree), flank_length, flank_angle};
}

CutterShape
CutterShape::taperedBullNose(double radius, double corner_radius, double flank_length, double flank_angle)
{
  return {radius, corner_radius, flank_length, flank_angle};
}

Diagnostic
faultOf(const CutterShape& s)
{
  if (!(s.radius > 0.0) || !(s.radius <= largest_radius))
    return faultText("the cutter's radius is", s.radius, " {mm}; set it above 0");
  if (!(s.flank_angle >= 0.0) || !(s.flank_angle <= steepest_angle))
    return faultText("the cutter's flank angle is", s.flank_angle, " {degrees}; set it between 0 and 89.9");
  if (!(s.flank_length >= 0.0) || !(s.flank_length <= largest_radius))
    return faultText("the cutter's flank length is", s.flank_length, " {mm}; set it to 0 or more");
  const double sine = std::sin(s.flank_angle * degree), cosine = std::cos(s.flank_angle * degree);
  if (flankRadiusOf(s) < -rounding * s.radius)
    return faultText("the flank is too long, it meets the axis above its lower end: its length is", s.flank_length, " {mm}") +
           faultText("; set it to", s.radius / sine, " {mm} or less, or change the flank angle or the radius");
  if (!(s.corner_radius >= 0.0) || !(s.corner_radius <= largest_radius))
    return faultText("the cutter's corner radius is", s.corner_radius, " {mm}; set it to 0 or more (a tapered ball needs R > L sin alpha)");
  if (flatRadiusOf(s) < -rounding * s.radius)
    return faultText("the corner reaches across the axis: its radius is", s.corner_radius, " {mm}") +
           faultText("; set it to", std::max(0.0, flankRadiusOf(s) / cosine), " {mm} (a ball end) or less");
  return {};
}

CutterProfile::CutterProfile(const CutterShape& shape) : shape_(shape)
{
  if (const Diagnostic fault = faultOf(shape); !fault.empty())
    throw std::invalid_argument("CutterProfile: " + fault.text());
  flank_angle_ = shape.flank_angle * degree;
  sin_angle_ = std::sin(flank_angle_);
  cos_angle_ = std::cos(flank_angle_);
  flank_radius_ = std::max(0.0, flankRadiusOf(shape));
  flat_radius_ = flatRadiusOf(shape);
  if (flat_radius_ < rounding * shape.radius)
    flat_radius_ = 0.0;
  if (flank_angle_ == 0.0)
    flank_radius_ = shape.radius;
  corner_height_ = shape.corner_radius * (1.0 - sin_angle_);
  top_height_ = corner_height_ + shape.flank_length * cos_angle_;
}

double
CutterProfile::height(double l) const
{
  if (l <= flat_radius_)
    return 0.0;
  if (l < flank_radius_) {
    const double r = shape_.corner_radius, d = std::min(l - flat_radius_, r * cos_angle_);
    return d * d / (r + std::sqrt(r * r - d * d)); // r - sqrt(r^2 - d^2) without loss of digits
  }
  if (l == flank_radius_)
    return corner_height_;
  if (l <= shape_.radius)
    return corner_height_ + (l - flank_radius_) * cos_angle_ / sin_angle_;
  return std::numeric_limits<double>::infinity();
}

double
CutterProfile::radiusAt(double height) const
{
  if (height < 0.0)
    return 0.0;
  if (height < corner_height_)
    return std::min(flank_radius_, flat_radius_ + std::sqrt(height * (2.0 * shape_.corner_radius - height)));
  if (height < top_height_)
    return flank_radius_ + (height - corner_height_) * sin_angle_ / cos_angle_;
  return shape_.radius;
}

Eigen::Vector2d
CutterProfile::normal(double l) const
{
  if (l <= flat_radius_ && flat_radius_ > 0.0)
    return {0.0, -1.0};
  if (l <= flank_radius_ && shape_.corner_radius > 0.0) {
    const double sine = std::min((l - flat_radius_) / shape_.corner_radius, cos_angle_);
    return {sine, -std::sqrt(1.0 - sine * sine)};
  }
  return {cos_angle_, -sin_angle_};
}

CutterContact
CutterProfile::locate(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, const Eigen::Vector3d& axis) const
{
  const Eigen::Vector3d across = normal - normal.dot(axis) * axis;
  const double sine = across.norm(), cosine = normal.dot(axis);
  const double lean = std::atan2(sine, cosine), steepest = 0.5 * pi - flank_angle_;
  CutterContact contact;
  contact.touches = lean <= steepest + angle_rounding;
  if (!contact.touches) {
    contact.part = CutterPart::Flank;
    contact.distance = shape_.radius;
    contact.height = top_height_;
    contact.excess_angle = (lean - steepest) / degree;
  }
  else if (shape_.flank_length > 0.0 && lean >= steepest - angle_rounding) {
    contact.part = CutterPart::Flank;
    contact.distance = flank_radius_;
    contact.height = corner_height_;
    contact.unique = false;
  }
  else if (sine <= angle_rounding && flat_radius_ > 0.0) {
    contact.part = CutterPart::Flat;
    contact.unique = false;
  }
  else {
    const double clamped = std::min(lean, steepest);
    contact.distance = flat_radius_ + shape_.corner_radius * std::sin(clamped);
    const double half = std::sin(0.5 * clamped);
    contact.height = 2.0 * shape_.corner_radius * half * half;
  }
  const Eigen::Vector3d outward = sine > 0.0 ? Eigen::Vector3d(across / sine) : Eigen::Vector3d(Eigen::Vector3d::Zero());
  contact.tip = point + contact.distance * outward - contact.height * axis;
  return contact;
}

CutterTouch
CutterProfile::touchAt(const Eigen::Vector3d& tip, const Eigen::Vector3d& axis, const Eigen::Vector3d& point,
                       const Eigen::Vector3d& normal) const
{
  constexpr double at_edge = 1e-3; // of R: places are known to the sag of a face
  const auto acrossAxis = [&](const Eigen::Vector3d& v) -> Eigen::Vector3d { return v - v.dot(axis) * axis; };
  const Eigen::Vector3d across = acrossAxis(point - tip), leaning = -acrossAxis(normal);
  const double l = across.norm(), z = (point - tip).dot(axis), steepest = 0.5 * pi - flank_angle_;
  const bool on_axis = l <= rounding * shape_.radius;
  const Eigen::Vector3d side = !on_axis                          ? Eigen::Vector3d(across / l)
                               : leaning.norm() > angle_rounding ? Eigen::Vector3d(leaning.normalized())
                                                                 : axis.unitOrthogonal();
  const bool sharp = shape_.corner_radius == 0.0 && std::hypot(l - flank_radius_, z) < at_edge * shape_.radius;
  double distance = l, height = 0.0, lean = 0.0; // of the place; angle between the cutter's normal and the axis, downwards
  if (sharp || l > flat_radius_) {
    const double wanted = sharp ? std::atan2(leaning.dot(side), normal.dot(axis)) : std::atan2(l - flat_radius_, shape_.corner_radius - z);
    lean = std::clamp(wanted, 0.0, steepest);
    distance = flat_radius_ + shape_.corner_radius * std::sin(lean);
    height = shape_.corner_radius * (1.0 - std::cos(lean));
    if (!sharp && wanted > steepest) { // on the flank
      const double up = (l - flank_radius_) * sin_angle_ + (z - corner_height_) * cos_angle_;
      distance = flank_radius_ + std::max(0.0, up) * sin_angle_;
      height = corner_height_ + std::max(0.0, up) * cos_angle_;
    }
  }
  return {tip + distance * side + height * axis, std::cos(lean) * axis - std::sin(lean) * side};
}

CutterProfile
insetCutter(const CutterProfile& profile, double depth)
{
  CutterShape shape = profile.shape();
  shape.radius -= depth * std::cos(profile.flankAngle());
  shape.corner_radius = std::max(0.0, shape.corner_radius - depth);
  return faultOf(shape).empty() ? CutterProfile(shape) : profile;
}

} // namespace pcl_spiral
