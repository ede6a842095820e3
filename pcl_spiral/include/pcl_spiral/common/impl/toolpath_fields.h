// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Writes a point of a toolpath to any point type.
 */
#pragma once

#include <pcl/impl/point_types.hpp>
#include <pcl/register_point_struct.h>
#include <pcl/type_traits.h>

#include <Eigen/Core>

#include <cmath>
#include <limits>
#include <type_traits>

// Names of the fields. A point type that has one of them declares it again, which does no harm.
namespace pcl::fields {
struct x;
struct y;
struct z;
struct normal_x;
struct normal_y;
struct normal_z;
struct axis_x;
struct axis_y;
struct axis_z;
struct arc_length;
struct turn;
struct over_gap;
struct lift;
} // namespace pcl::fields

namespace pcl_spiral {

/** True if the registered point type has the field, such as pcl::fields::turn. */
template <typename PointT, typename Field>
constexpr bool has_toolpath_field = pcl::traits::has_field<PointT, Field>::value;

/** \p value converted to another number type, as by static_cast. For integers, where the cast can be undefined, a value beyond the
 *  range becomes the nearest limit, and NaN becomes 0. */
template <typename Type, typename Number>
Type
numberAs(Number value)
{
  if constexpr (std::is_integral_v<Type> && !std::is_same_v<Type, bool> && std::is_floating_point_v<Number>) {
    using Limits = std::numeric_limits<Type>;
    if (std::isnan(value))
      return 0;
    if (value <= static_cast<Number>(Limits::lowest()))
      return Limits::lowest();
    if (value >= static_cast<Number>(Limits::max())) // max() may be rounded up to the next power of two
      return Limits::max();
  }
  return static_cast<Type>(value);
}

/** Write a number to the field of that name, converted by numberAs. Does nothing without that field. */
template <typename Field, typename PointT, typename Number>
void
setFieldIfPresent(PointT& point, Number value)
{
  if constexpr (has_toolpath_field<PointT, Field>) {
    using Type = typename pcl::traits::datatype<PointT, Field>::type;
    static_assert(std::is_arithmetic_v<Type>, "a toolpath writes numbers: register this field as a number, not as an array, or "
                                              "specialise pcl_spiral::ToolpathFields for the point type");
    pcl::setFieldValue(point, pcl::traits::offset<PointT, Field>::value, numberAs<Type>(value));
  }
}

/** How one point of a toolpath is written to a point of the user's type.
 *
 *  By default it fills the registered fields with these names and leaves every other member unchanged.
 *  In POINT_CLOUD_REGISTER_POINT_STRUCT the name is the third entry of each triple.
 *
 *  | field | holds |
 *  |---|---|
 *  | x y z | the cutter contact, mm; the type must have them |
 *  | normal_x normal_y normal_z | unit normal of the surface, out of the material |
 *  | axis_x axis_y axis_z | unit tool axis, from the tip to the shank |
 *  | arc_length | length of the path up to here, mm; on a path of 10 km a float is off by 0.5 mm |
 *  | turn | count of turns, with the fraction |
 *  | over_gap | 1 where the scan has a gap that was bridged, else 0 |
 *  | lift | distance of x y z from the surface where the ball does not reach it, mm, else 0 |
 *
 *  A field may have any number type. An integer field drops the digits after the decimal point. A value beyond the range becomes
 *  the nearest limit: -0.7 becomes 0 in an unsigned field. For a type with other names or other contents, specialise
 *  the struct before you use the type as an output:
 *  \code
 *  template <> struct pcl_spiral::ToolpathFields<Station> {
 *    static void set(Station& station, const Eigen::Vector3d& contact, const Eigen::Vector3d&,
 *                    const Eigen::Vector3f& axis, double arc_length, float, bool)
 *    {
 *      station.contact = contact;
 *      station.tool = axis;
 *      station.metres = 0.001 * arc_length;
 *    }
 *  };
 *  \endcode
 *  Several threads call it at once, each for its own point.
 */
template <typename PointT>
struct ToolpathFields {
  /** \param[out] point constructed by its default constructor
   *  \param[in] contact,normal,axis,arc_length,turn,over_gap see the table */
  static void set(PointT& point, const Eigen::Vector3d& contact, const Eigen::Vector3d& normal, const Eigen::Vector3f& axis,
                  double arc_length, float turn, bool over_gap)
  {
    namespace fields = pcl::fields;
    static_assert(has_toolpath_field<PointT, fields::x> && has_toolpath_field<PointT, fields::y> && has_toolpath_field<PointT, fields::z>,
                  "a point of a toolpath needs the registered fields x, y and z: name them in "
                  "POINT_CLOUD_REGISTER_POINT_STRUCT, or specialise pcl_spiral::ToolpathFields for the point "
                  "type");
    setFieldIfPresent<fields::x>(point, contact.x());
    setFieldIfPresent<fields::y>(point, contact.y());
    setFieldIfPresent<fields::z>(point, contact.z());
    setFieldIfPresent<fields::normal_x>(point, normal.x());
    setFieldIfPresent<fields::normal_y>(point, normal.y());
    setFieldIfPresent<fields::normal_z>(point, normal.z());
    setFieldIfPresent<fields::axis_x>(point, axis.x());
    setFieldIfPresent<fields::axis_y>(point, axis.y());
    setFieldIfPresent<fields::axis_z>(point, axis.z());
    setFieldIfPresent<fields::arc_length>(point, arc_length);
    setFieldIfPresent<fields::turn>(point, turn);
    setFieldIfPresent<fields::over_gap>(point, over_gap);
  }
  /** Sets the field lift. A specialisation need not have this function. */
  static void setLift(PointT& point, double lift) { setFieldIfPresent<pcl::fields::lift>(point, lift); }
};

/** Calls ToolpathFields<PointT>::setLift if there is one. */
template <typename PointT>
auto
setToolpathLift(PointT& point, double lift, int) -> decltype(ToolpathFields<PointT>::setLift(point, lift))
{
  ToolpathFields<PointT>::setLift(point, lift);
}
template <typename PointT>
void
setToolpathLift(PointT&, double, long)
{}

} // namespace pcl_spiral
