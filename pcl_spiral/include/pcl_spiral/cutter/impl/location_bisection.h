/** \file
 *  Locations close enough for the cutter to go straight from one to the next.
 */
#pragma once

#include <pcl_spiral/cutter/impl/cutter_locator.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

struct BisectionSettings {
  double tolerance = 0.01; ///< mm: no move cuts deeper than this into the surface, nor passes it farther off
  int most_halvings = 12;  ///< of one move; one that is still beyond the tolerance then is reported
};

/** What a bisection came to, lengths in mm. */
struct BisectionFigures {
  std::size_t inserted = 0;
  double largest_error = 0.0; ///< of all moves: a bound of what they cut, or what is left in the middle if that is
                              ///< more; and what thinning moves on top
  std::size_t unresolved = 0; ///< moves beyond the tolerance still, their error in largest_error
  Eigen::Vector3d worst_place = Eigen::Vector3d::Zero(); ///< tip in the middle of the move with the largest error
  std::size_t not_judged = 0; ///< moves from or to a location without a cloud
};

/** Puts locations between those of \p passes, each in travel order, until no move errs by more than the tolerance.
 *
 *  The error of a move is what it may cut, by CutterLocator::moveError, or how far the cutter in its middle stands above where it
 *  would touch, whichever is more. Where that is too large the middle becomes a location: the axis is the sum of
 *  both axes, of unit length, and the cutter comes down along it through the middle of both tips. Source: Sun, Cui,
 *  Kang, Wang, five-axis NC toolpath generation from scattered points. Our additions: what is left is judged as
 *  well; and as the bound of clouds supposes the worst between two locations (a sharp edge on a slope needs them
 *  0.05 mm apart), moves are halved to half the tolerance, and then of the locations put in those go again without which
 *  the cutter moves by no more than the other half. What was given stays. The same for any number of threads.
 *  Fails as CutterLocator::locate does, and where a setting is out of range; \p passes are then as they were. */
Status bisectLocations(const CutterLocator& locator, const BisectionSettings& settings,
                       const ProgressCallback& progress, std::vector<ToolLocations>& passes,
                       BisectionFigures& figures);

} // namespace pcl_spiral
