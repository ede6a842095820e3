/** \file
 *  Lines from the centre or inner loop to given places on the rim. Private to toolpath.
 */
#pragma once

#include <pcl_spiral/geodesic/harmonic_field.h>
#include <pcl_spiral/toolpath/radial_line_builder.h>
#include <pcl_spiral/toolpath/surface_centre.h>

namespace pcl_spiral {

/** Makes batches of lines by one method. */
class LineSource {
public:
  /** \p harmonic: gradient lines as they are; otherwise geodesics, which start from the distance field's (one boundary)
   *  or the harmonic function's lines (two). */
  LineSource(const RadialLineRequest& request, const SurfaceCentre& centre, bool harmonic);

  /** Solve the field behind the lines. */
  Status prepare();

  /** A line to each place on the rim. On failure the message says where. */
  Status make(const Polyline& rim_places, std::vector<RadialLine>& lines) const;

private:
  Status refine(std::vector<Polyline>& traces, std::vector<RadialLine>& lines) const;
  Status putOnSurface(std::vector<Polyline>& traces, std::vector<RadialLine>& lines) const;
  Status fit(std::vector<RadialLine>& lines) const;

  const RadialLineRequest& request_;
  const SurfaceCentre& centre_;
  bool harmonic_;
  DistanceField own_distance_;
  const DistanceField* distance_ = nullptr;
  HarmonicField potential_;
};

} // namespace pcl_spiral
