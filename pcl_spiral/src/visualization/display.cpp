// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/visualization/pictures.h>

#include <X11/Xlib.h>

#include <cstdlib>

namespace pcl_spiral {

std::string
displayFault()
{
  const char* const name = std::getenv("DISPLAY");
  if (!name || !*name)
    return "DISPLAY is not set";
  // VTK ends the program if this fails. The connection stays open until the program ends: a server such as
  // Xvfb restarts when its last client leaves, and refuses connections during the restart, between one picture
  // and the next.
  static Display* display = nullptr;
  if (!display)
    display = XOpenDisplay(nullptr);
  if (!display)
    return "'" + std::string(name) + "' cannot be opened";
  int opcode = 0, event = 0, error = 0;
  if (!XQueryExtension(display, "GLX", &opcode, &event, &error))
    return "'" + std::string(name) + "' cannot draw with OpenGL because it has no GLX";
  return {};
}

std::string
displayProblem()
{
  const std::string fault = displayFault();
  return fault.empty() ? fault
                       : "a picture needs a display and " + fault +
                             "; run the same command under 'xvfb-run -a' (package xvfb), or leave the picture out";
}

} // namespace pcl_spiral
