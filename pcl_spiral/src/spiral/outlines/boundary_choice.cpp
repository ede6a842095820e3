// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/impl/boundary_choice.h>

#include <pcl_spiral/core/diagnostic.h>

namespace pcl_spiral {

Status
chooseBoundaries(const std::vector<BoundaryLoop>& loops, BoundaryMode mode, BoundaryChoice& choice)
{
  choice = BoundaryChoice();
  std::vector<const BoundaryLoop*> holes;
  for (const BoundaryLoop& loop : loops) {
    if (loop.type == LoopType::Outer && !choice.rim)
      choice.rim = &loop;
    if (loop.type == LoopType::Inner || (loop.type == LoopType::ScanGap && mode == BoundaryMode::TwoBoundaries))
      holes.push_back(&loop);
  }
  if (!choice.rim)
    return {StatusCode::InvalidInput, "none of the loops is an outer one: a spiral ends on the outer rim, so give that loop"};
  if (mode == BoundaryMode::TwoBoundaries && holes.empty())
    return {StatusCode::InvalidArgument, "two boundaries were set, but the surface has only one: set one, or let the library choose "
                                         "({setBoundaryMode})"};
  if (mode == BoundaryMode::Automatic && holes.size() > 1) {
    Diagnostic message = Diagnostic("the surface has ", holes.size(), " holes:");
    for (const BoundaryLoop* hole : holes)
      message += Diagnostic(" ", Place(hole->curve.front()), " length ", hole->length, " {mm};");
    message += " a spiral runs between at most two boundaries: set one boundary to bridge all holes, or two to "
               "keep the longest hole and bridge the others ({setBoundaryMode})";
    return {StatusCode::InvalidInput, message};
  }
  if (mode == BoundaryMode::AllBoundaries)
    choice.kept = holes;
  else if (mode != BoundaryMode::OneBoundary)
    for (const BoundaryLoop* hole : holes)
      if (!choice.inner || hole->length > choice.inner->length)
        choice.inner = hole;
  if (choice.inner)
    choice.kept.assign(1, choice.inner);
  return Status::success();
}

} // namespace pcl_spiral
