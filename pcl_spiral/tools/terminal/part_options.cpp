// SPDX-License-Identifier: BSD-3-Clause
#include "part_choice.h"

using namespace pcl_spiral;

std::vector<Option>
placeOptions(PartChoice& choice)
{
  return {placeOption("part-at",
                      "a place on the part, in the coordinates of the file: of several separate parts use the nearest one: "
                      "--part-at 120,80,15",
                      choice.part_at),
          textOption("crop", "BOX|FILE",
                     "only points inside are part of the scan: xmin,xmax,ymin,ymax or also ,zmin,zmax, or the file of a polygon, in the "
                     "coordinates of the file of the scan: --crop 0,200,0,150",
                     choice.crop),
          {"keep-out", "FILE",
           "the cutter does not enter the space over and under this polygon; may be given several times; one corner per line: x y, "
           "extended along z, or x y z, extended along its mean normal: --keep-out clamp.txt",
           [&choice](const std::string& value) { choice.keep_outs.push_back(value); }, true}};
}

Option
clustersOption(PartChoice& choice)
{
  return choiceOption("clusters",
                      "two or more points near each other that stand off the surface, as a screw or spatter, are refused, ridden over "
                      "without cutting into them, or left out as false echoes, and the path goes through them; default refuse: "
                      "--clusters ride",
                      choice.clusters);
}

std::vector<InputName>
polygonFiles(const PartChoice& choice)
{
  std::vector<InputName> files{{"the crop", choice.crop}};
  for (const std::string& file : choice.keep_outs)
    files.push_back({"a keep-out", file});
  return files;
}
