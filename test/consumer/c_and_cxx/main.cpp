// Uses the installed headers and library from a project with C in it.
#include <pcl_spiral/core/polyline.h>

#include <iostream>

extern "C" double
metres_to_millimetres(double metres);

int
main()
{
  const double side = metres_to_millimetres(0.1);
  const pcl_spiral::Polyline square{{0, 0, 0}, {side, 0, 0}, {side, side, 0}, {0, side, 0}};
  std::cout << "c_and_cxx: outline " << pcl_spiral::length(square, true) << " mm\n";
  return pcl_spiral::length(square, true) == 400.0 ? 0 : 1;
}
