// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Words of a picture that have a limited room. Private to visualization.
 */
#pragma once

#include <vtkRenderer.h>
#include <vtkTextActor.h>

namespace pcl_spiral {

/** Makes the words of \p actor at most \p room pixels wide in \p view: first by a smaller font, 12 at the least, then by
 * three dots in place of their middle. Words that fit stay as they are. */
void fitText(vtkTextActor* actor, vtkRenderer* view, double room);

/** Pixels from \p x to the right edge of \p view, less a margin. */
double roomRightOf(double x, vtkRenderer* view);

} // namespace pcl_spiral
