// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Keeps VTK's own messages off the console.
 */
#pragma once

#include <vtkObject.h>

namespace pcl_spiral {

/** While it lives, VTK prints nothing: the caller looks at the result and says what is wrong itself. */
class QuietVtk {
public:
  QuietVtk() : before_(vtkObject::GetGlobalWarningDisplay()) { vtkObject::GlobalWarningDisplayOff(); }
  ~QuietVtk() { vtkObject::SetGlobalWarningDisplay(before_); }
  QuietVtk(const QuietVtk&) = delete;
  QuietVtk& operator=(const QuietVtk&) = delete;

private:
  int before_;
};

} // namespace pcl_spiral
