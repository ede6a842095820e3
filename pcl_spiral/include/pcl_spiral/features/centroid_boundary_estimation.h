// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Boundary points of a cloud.
 */
#pragma once

#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/features/impl/boundary_evidence.h>

#include <pcl/features/boundary.h>
#include <pcl/point_types.h>

#include <vector>

namespace pcl_spiral {
namespace detail {

/** Call setNumberOfThreads of the base class if it has it, as in PCL from 2026 on. */
template <typename BaseT>
auto
setThreadsOfBase(BaseT& base, unsigned int threads, int) -> decltype(base.BaseT::setNumberOfThreads(threads))
{
  base.BaseT::setNumberOfThreads(threads);
}
template <typename BaseT>
void
setThreadsOfBase(BaseT&, unsigned int, long)
{}

} // namespace detail

/** Finds boundary points by the distance of a point from the centroid of its neighbours, by the largest angular gap
 * around it, or both.
 *
 *  Is a pcl::BoundaryEstimation: setInputCloud, setInputNormals, setIndices, setSearchMethod, setKSearch or
 *  setRadiusSearch, compute. Source of the score: Wu et al. 2025, equation 1, kappa = exp(mu lambda), with
 * lambda made dimensionless (BoundaryEvidence::offset). On random points with setKSearch(32), the default
 * thresholds mark this share of the points:
 *
 *  |            | within 0.5 spacings of the edge | inside |
 *  |------------|---------------------------------|--------|
 *  | Centroid   | 92 %                            | 0.3 %  |
 *  | LargestGap | 92 %                            | 0.00 % |
 *  | Combined   | 99 %                            | 0.15 % |
 *
 *  Fewer neighbours mark more false boundary points inside (Combined: 1.5 % at 24, 11 % at 16). The angular gap at
 * a re-entrant corner is little above 90 degrees, so random points hide about half of those corners. On even
 * points, set the angle threshold to 95 degrees, and Combined finds them. A point or normal that is not finite,
 * and a point with fewer than three neighbours, is not a boundary point; its score is NaN and the output is not
 * dense. On failure the output is empty and getStatus gives the reason. */
template <typename PointInT, typename PointNT, typename PointOutT = pcl::Boundary>
class CentroidBoundaryEstimation : public pcl::BoundaryEstimation<PointInT, PointNT, PointOutT> {
public:
  using Base = pcl::BoundaryEstimation<PointInT, PointNT, PointOutT>; ///< The base class of PCL.
  using Ptr = pcl::shared_ptr<CentroidBoundaryEstimation>;            ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const CentroidBoundaryEstimation>; ///< A shared pointer to a constant one.
  using PointCloudOut = typename Base::PointCloudOut;                 ///< The cloud of the output.

  /** The angle threshold, which the base class keeps in radians, starts at 121 degrees: with 32 neighbours, no angular
   * gap inside is wider. */
  CentroidBoundaryEstimation();

  /** Which measure decides; Combined by default. */
  void setCriterion(BoundaryCriterion criterion) { criterion_ = criterion; }
  BoundaryCriterion getCriterion() const { return criterion_; } ///< The value of setCriterion.

  /** Offset above which a point is a boundary point, 0 to 1; 0.31 by default: with 32 neighbours, 99.9 % of the
   * points inside are below it and 99 % of those on the boundary are above it. */
  void setOffsetThreshold(double threshold) { offset_threshold_ = threshold; }
  double getOffsetThreshold() const { return offset_threshold_; } ///< The value of setOffsetThreshold.

  /** The mu of the score exp(mu offset); 1 by default. It changes the score, but not the decision. */
  void setMu(double mu) { mu_ = mu; }
  double getMu() const { return mu_; } ///< The value of setMu.

  /** Threads to use; 0, the default, means all. The output does not depend on it. The search method must
   * allow simultaneous queries, as those of PCL do. Newer PCL (2026) has this method in the base class, where it is not
   * virtual. The base gets the same number, and a number set later through the base counts too. */
  void setNumberOfThreads(unsigned int threads = 0)
  {
    thread_count_ = threads;
    if (checkThreads(threads).ok())
      detail::setThreadsOfBase(static_cast<Base&>(*this), threads, 0);
    told_base_ = threadsOfBase(*this, 0);
  }
  /** The value of setNumberOfThreads, of this class or of its base. */
  unsigned int getNumberOfThreads() const
  {
    const unsigned int of_base = threadsOfBase(*this, 0);
    return of_base != told_base_ ? of_base : thread_count_;
  }

  /** Build the search structure again at the next compute. Needed if points of the input cloud were changed
   * in place: PCL rebuilds it only if the cloud pointer changes. */
  void resetSearch() { rebuild_search_ = true; }

  /** Score kappa = exp(mu offset) of each output point of the last compute. */
  const std::vector<float>& getScores() const { return scores_; }
  /** Offset of each output point, 0 to 1. */
  const std::vector<float>& getOffsets() const { return offsets_; }
  /** Largest angular gap about each output point, radians. */
  const std::vector<float>& getGaps() const { return gaps_; }

  const Status& getStatus() const { return status_; } ///< Result of the last compute.

protected:
  bool initCompute() override;                         ///< Checks the settings, then calls the base class.
  void computeFeature(PointCloudOut& output) override; ///< What pcl::Feature calls.

  using Base::angle_threshold_;
  using Base::feature_name_;
  using Base::indices_;
  using Base::input_;
  using Base::k_;
  using Base::normals_;
  using Base::search_parameter_;
  using Base::search_radius_;
  using Base::surface_;
  using Base::tree_;

private:
  Status check() const;
  Status checkSearch() const;
  bool evaluate(std::size_t index, BoundaryEvidence& evidence) const;

  /** The number that the base class keeps; 0 if it keeps none, as in PCL before 2026. */
  template <typename SelfT>
  static auto threadsOfBase(const SelfT& self, int) -> decltype(static_cast<unsigned int>(self.threads_))
  {
    return static_cast<unsigned int>(self.threads_);
  }
  template <typename SelfT>
  static unsigned int threadsOfBase(const SelfT&, long)
  {
    return 0;
  }

  BoundaryCriterion criterion_ = BoundaryCriterion::Combined;
  double offset_threshold_ = 0.31;
  double mu_ = 1.0;
  unsigned int thread_count_ = 0;
  unsigned int told_base_ = 0; ///< the number that the base kept after the last call here
  bool rebuild_search_ = false;
  std::vector<float> scores_, offsets_, gaps_;
  Status status_;
};

} // namespace pcl_spiral

#include <pcl_spiral/features/impl/centroid_boundary_estimation.hpp>

namespace pcl_spiral {
extern template class CentroidBoundaryEstimation<pcl::PointXYZ, pcl::Normal>;
extern template class CentroidBoundaryEstimation<pcl::PointXYZRGB, pcl::Normal>;
extern template class CentroidBoundaryEstimation<pcl::PointNormal, pcl::Normal>;
extern template class CentroidBoundaryEstimation<pcl::PointNormal, pcl::PointNormal>;
} // namespace pcl_spiral
