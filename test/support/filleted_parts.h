// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Meshes of parts with flat faces and fillets, as CAD programs make them, with their exact surface. Lengths in mm, angles in degrees.
 */
#pragma once

#include "support/meshes.h"

#include <Eigen/Geometry>

namespace pcl_spiral::test {

/** A line of straight pieces whose corners are rounded by arcs tangent to both, in the plane of r and z. */
class RoundedProfile {
public:
  struct Corner {
    Eigen::Vector2d at;
    double radius = 0.0; ///< of its rounding; the first and the last have none
  };
  struct Piece {
    std::vector<Eigen::Vector2d> points; ///< of the mesh
    bool is_arc = false;
    Eigen::Vector2d centre;
    double radius = 0.0;
  };

  RoundedProfile(const std::vector<Corner>& corners, double facet);

  const std::vector<Piece>& pieces() const { return pieces_; }
  /** Beyond its ends the line goes on straight. */
  double distance(const Eigen::Vector2d& at) const;

private:
  std::vector<Piece> pieces_;
};

/** What the profile is moved along: r is the distance from it, z the height. */
struct SweepGuide {
  enum class Form { Line, Rectangle } form = Form::Line;
  Eigen::Vector2d half{0.0, 0.0}; ///< of a rectangle in x and y, with round corners outside of it; of a line in y. (0, 0): a circle
  double facet = 10.0;            ///< degrees, of the round corners
  int parts = 1;                  ///< a line is cut in so many
  bool split_floor = false;       ///< the floor inside is a fan about its middle; else about one corner
};

/** The mesh, and which of its faces are flat in the part. */
struct FilletedPart {
  TriangleMesh mesh;
  std::vector<std::uint8_t> is_flat;
  RoundedProfile profile;
  SweepGuide guide;
  Eigen::Isometry3d placed = Eigen::Isometry3d::Identity(); ///< from its own frame to that of the mesh

  double distance(const Eigen::Vector3d& at) const; ///< from the exact surface, unsigned
};

FilletedPart sweptPart(const RoundedProfile& profile, const SweepGuide& guide);

/** The part, turned and moved. */
FilletedPart placedPart(FilletedPart part, const Eigen::Isometry3d& by);

} // namespace pcl_spiral::test
