#include <pcl_spiral/visualization/pictures.h>

#include <X11/Xlib.h>

#include <cstdlib>

namespace pcl_spiral {

std::string
displayProblem()
{
  const std::string remedy =
      "; run the same command under 'xvfb-run -a' (package xvfb), or leave the picture out";
  const char* const name = std::getenv("DISPLAY");
  if (!name || !*name)
    return "a picture needs a display and DISPLAY is not set" + remedy;
  // VTK ends the program where this fails. The connection is kept until the program's end: a server such as
  // Xvfb starts afresh when its last client leaves, and refuses connections meanwhile, between one picture
  // and the next.
  static const Display* display = nullptr;
  if (!display)
    display = XOpenDisplay(nullptr);
  if (!display)
    return "a picture needs a display and '" + std::string(name) + "' cannot be opened" + remedy;
  return {};
}

} // namespace pcl_spiral
