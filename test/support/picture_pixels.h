// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Pixels of a picture of 1600 x 1200.
 */
#pragma once

#include <gtest/gtest.h>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <string>

namespace pcl_spiral::test {

using Pixel = std::array<int, 3>;

inline vtkSmartPointer<vtkImageData>
readPicture(const std::string& file)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  int size[3];
  reader->GetOutput()->GetDimensions(size);
  EXPECT_EQ(size[0], 1600);
  EXPECT_EQ(size[1], 1200);
  return reader->GetOutput();
}

inline Pixel
at(vtkImageData* image, int x, int y)
{
  const auto* const p = static_cast<const unsigned char*>(image->GetScalarPointer(x, y, 0));
  return {p[0], p[1], p[2]};
}

/** How often each colour occurs in the columns of pixels from \p first to before \p last. */
inline std::map<Pixel, std::size_t>
colorsOf(const std::string& file, int first = 0, int last = 1600)
{
  const auto image = readPicture(file);
  std::map<Pixel, std::size_t> counts;
  for (int y = 0; y < 1200; ++y)
    for (int x = first; x < last; ++x)
      ++counts[at(image, x, y)];
  return counts;
}

template <typename Matches>
double
share(const std::map<Pixel, std::size_t>& counts, Matches matches)
{
  double all = 0.0, matching = 0.0;
  for (const auto& [pixel, count] : counts) {
    all += static_cast<double>(count);
    matching += matches(pixel) ? static_cast<double>(count) : 0.0;
  }
  return matching / all;
}

inline bool
isWhite(const Pixel& p)
{
  return p[0] == 255 && p[1] == 255 && p[2] == 255;
}

/** The surface is gray, lines on it are not. */
inline bool
isGray(const Pixel& p)
{
  const auto [low, high] = std::minmax({p[0], p[1], p[2]});
  return high - low < 25 && high < 245 && low > 60;
}

} // namespace pcl_spiral::test
