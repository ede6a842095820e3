// SPDX-License-Identifier: BSD-3-Clause
#include "loop_matching.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double widest_way = 4.0; // to the next partner, in units of the even one

/** The cost of pairs, and the cheapest ones for a given first partner. */
class Matching {
public:
  Matching(const Polyline& seeds, const Polyline& candidates)
  : n_(seeds.size()), m_(candidates.size()), even_(static_cast<double>(m_) / static_cast<double>(n_)),
    widest_(std::min(m_, static_cast<std::size_t>(std::ceil(widest_way * even_)))), lengths_(n_ * m_)
  {
    double whole = 0.0;
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t k = 0; k < m_; ++k)
        whole += lengths_[i * m_ + k] = (seeds[i] - candidates[k]).norm();
    for (double& length : lengths_)
      length *= whole > 0.0 ? static_cast<double>(lengths_.size()) / whole : 0.0;
  }

  double length(std::size_t i, std::size_t partner) const { return lengths_[i * m_ + partner % m_]; }
  double spacing(std::size_t way) const
  {
    const double off = static_cast<double>(way) / even_ - 1.0;
    return off * off;
  }

  /** Least cost with seed 0 at candidate \p first. \p ways, unless null, gets the ways from one partner to
   *  the next. */
  double best(std::size_t first, std::vector<std::size_t>* ways) const
  {
    std::vector<double> cost(m_ + 1, infinite), next;
    std::vector<std::size_t> came((ways ? n_ : 0) * (m_ + 1)); // the way that led to each seed and advance
    cost[0] = length(0, first);
    for (std::size_t i = 1; i <= n_; ++i) { // the last one is seed 0 again
      next.assign(m_ + 1, infinite);
      for (std::size_t a = i < n_ ? 0 : m_; a <= m_; ++a) {
        for (std::size_t way = 0; way <= std::min(a, widest_); ++way)
          if (const double sum = cost[a - way] + spacing(way); sum < next[a]) {
            next[a] = sum;
            if (ways)
              came[(i - 1) * (m_ + 1) + a] = way;
          }
        next[a] += i < n_ ? length(i, first + a) : 0.0;
      }
      cost.swap(next);
    }
    if (ways) {
      ways->resize(n_);
      for (std::size_t i = n_, a = m_; i-- > 0; a -= (*ways)[i])
        (*ways)[i] = came[i * (m_ + 1) + a];
    }
    return cost[m_];
  }

private:
  std::size_t n_, m_;
  double even_;
  std::size_t widest_;
  std::vector<double> lengths_; ///< over their mean
};

} // namespace

std::vector<std::size_t>
matchLoops(const Polyline& seeds, const Polyline& candidates)
{
  const Matching matching(seeds, candidates);
  std::vector<double> costs(candidates.size());
  const auto count = static_cast<std::int64_t>(candidates.size());
#pragma omp parallel for schedule(static)
  for (std::int64_t first = 0; first < count; ++first)
    costs[first] = matching.best(first, nullptr);
  std::vector<std::size_t> ways, partners;
  partners.push_back(std::min_element(costs.begin(), costs.end()) - costs.begin());
  matching.best(partners.front(), &ways);
  for (std::size_t i = 0; i + 1 < seeds.size(); ++i)
    partners.push_back(partners.back() + ways[i]);
  return partners;
}

double
matchingCost(const Polyline& seeds, const Polyline& candidates, const std::vector<std::size_t>& partners)
{
  const Matching matching(seeds, candidates);
  double cost = 0.0;
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const std::size_t next = i + 1 < seeds.size() ? partners[i + 1] : partners[0] + candidates.size();
    cost += matching.length(i, partners[i]) + matching.spacing(next - partners[i]);
  }
  return cost;
}

} // namespace pcl_spiral
