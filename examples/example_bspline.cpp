// SPDX-License-Identifier: BSD-3-Clause
// A cubic B-spline through the points of a radial line: fewer knots than points, deviation, points at equal
// steps.
#include <pcl_spiral/core/bspline_fit.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

int
main(int argc, char** argv)
{
  pcl_spiral::BSplineFitOptions options;
  options.tolerance = argc > 1 ? std::atof(argv[1]) : 0.001; // mm
  pcl_spiral::Polyline points;                               // from the pole of a dome to its rim
  for (int i = 0; i <= 128; ++i) {
    const double a = 0.5 * M_PI * i / 128.0;
    points.emplace_back(1650.0 * std::sin(a), 100.0 * std::sin(3.0 * a), 860.0 * std::cos(a));
  }
  const auto fit = pcl_spiral::fitBSpline(points, options);
  if (!fit) {
    std::fprintf(stderr, "usage: example_bspline [TOLERANCE], mm, above 0\n");
    return 2;
  }
  std::printf("%zu points, %zu spans, deviation max %.2e rms %.2e mm%s\n", points.size(), fit->curve.spans(), fit->max_deviation,
              fit->rms_deviation, fit->within_tolerance ? "" : " (above the tolerance)");
  std::printf("length %.6f mm\n", fit->curve.length());
  for (double s = 0.0; s < fit->curve.length(); s += 250.0) {
    const Eigen::Vector3d p = fit->curve.positionAt(s), t = fit->curve.tangentAt(s);
    std::printf("s %7.1f  point %9.3f %9.3f %9.3f  tangent %6.3f %6.3f %6.3f\n", s, p.x(), p.y(), p.z(), t.x(), t.y(), t.z());
  }
  return 0;
}
