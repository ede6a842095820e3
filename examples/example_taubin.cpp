// SPDX-License-Identifier: BSD-3-Clause
// Smooths a jagged closed line by a wavelength in mm: it removes the noise and keeps the size and the corner.
#include <pcl_spiral/core/polyline.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

namespace {

void
print(const char* name, const pcl_spiral::Polyline& line)
{
  double sum = 0.0, squares = 0.0;
  for (const Eigen::Vector3d& p : line) {
    sum += p.norm() - 100.0;
    squares += (p.norm() - 100.0) * (p.norm() - 100.0);
  }
  const double n = static_cast<double>(line.size());
  std::printf("%-10s radius - 100: mean %8.5f mm, rms %8.5f mm\n", name, sum / n, std::sqrt(squares / n));
}

} // namespace

int
main(int argc, char** argv)
{
  pcl_spiral::TaubinOptions options;
  options.wavelength = argc > 1 ? std::atof(argv[1]) : 10.0; // mm
  options.closed = true;
  options.pinned = {0};
  if (!(options.wavelength > 0.0)) {
    std::fprintf(stderr, "usage: example_taubin [WAVELENGTH], mm, above 0\n");
    return 2;
  }
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, 0.05);
  pcl_spiral::Polyline line;
  for (int i = 0; i < 1200; ++i) {
    const double a = 2.0 * M_PI * i / 1200.0, r = 100.0 + (i ? noise(random) : 0.0);
    line.emplace_back(r * std::cos(a), r * std::sin(a), 0.0);
  }
  print("given", line);
  const pcl_spiral::Polyline smooth = pcl_spiral::taubinSmoothed(line, options);
  print("smoothed", smooth);
  std::printf("pinned point moved by %g mm\n", (smooth[0] - line[0]).norm());
  for (double share : {0.5, 1.0, 2.0, 4.0})
    std::printf("gain on a wave of %6.2f mm: %.4f\n", share * options.wavelength,
                pcl_spiral::taubinGain(share * options.wavelength, 0.5236, options));
  return 0;
}
