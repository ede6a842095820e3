// SPDX-License-Identifier: BSD-3-Clause
#include "patch_moments.h"

#include "core/lanes.h"

#include "core/simd_clones.h"

namespace pcl_spiral {
namespace {

/** The sums of one pass, and then of the lanes; \p size is a multiple of eight. */
PCL_SPIRAL_SIMD_CLONES void
sumMoments(const float* x, const float* y, const float* z, int size, const float* frame, Moments& m)
{
  Lanes w = {}, su = {}, sv = {}, uu = {}, uv = {}, vv = {}, uuu = {}, uuv = {}, uvv = {}, vvv = {};
  Lanes uuuu = {}, uuuv = {}, uuvv = {}, uvvv = {}, vvvv = {};
  Lanes f = {}, fu = {}, fv = {}, fuu = {}, fuv = {}, fvv = {}, ff = {}, mean_u = {}, mean_v = {};
  for (int j = 0; j < size; j += lane_count) {
    Lanes px, py, pz;
    load(px, x + j);
    load(py, y + j);
    load(pz, z + j);
    const Lanes a = px * frame[0] + py * frame[1] + pz * frame[2];
    const Lanes b = px * frame[3] + py * frame[4] + pz * frame[5];
    const Lanes h = px * frame[6] + py * frame[7] + pz * frame[8];
    const Lanes rest = 1.0f - (a * a + b * b);
    const Lanes inside = rest > 0.0f ? rest : Lanes{};
    const Lanes weight = inside * inside * inside;
    const Lanes wa = weight * a, wb = weight * b, waa = wa * a, wab = wa * b, wbb = wb * b, wh = weight * h;
    const Lanes aa = a * a, ab = a * b, bb = b * b;
    mean_u += a, mean_v += b;
    w += weight;
    su += wa, sv += wb, uu += waa, uv += wab, vv += wbb;
    uuu += waa * a, uuv += waa * b, uvv += wab * b, vvv += wbb * b;
    uuuu += waa * aa, uuuv += waa * ab, uuvv += waa * bb, uvvv += wab * bb, vvvv += wbb * bb;
    f += wh, fu += wa * h, fv += wb * h, fuu += waa * h, fuv += wab * h, fvv += wbb * h;
    ff += wh * h;
  }
  m = {sum(w),    sum(su),   sum(sv),   sum(uu), sum(uv), sum(vv), sum(uuu), sum(uuv), sum(uvv), sum(vvv), sum(uuuu),   sum(uuuv),
       sum(uuvv), sum(uvvv), sum(vvvv), sum(f),  sum(fu), sum(fv), sum(fuu), sum(fuv), sum(fvv), sum(ff),  sum(mean_u), sum(mean_v)};
}

} // namespace

void
momentsOf(const Patch& patch, const float* frame, Moments& moments)
{
  const int whole = padded(patch.size);
  sumMoments(patch.x, patch.y, patch.z, whole, frame, moments);
  moments.w -= static_cast<float>(whole - patch.size); // the zeros at the end lie at the query, where the weight is 1
  moments.mean_u /= static_cast<float>(patch.size);
  moments.mean_v /= static_cast<float>(patch.size);
}

} // namespace pcl_spiral
