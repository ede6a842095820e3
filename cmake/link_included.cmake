# SPDX-License-Identifier: BSD-3-Clause
# Links a program of one source file to the libraries whose headers it includes.
function(pcl_spiral_link_included target source)
  target_link_libraries(${target} PRIVATE pcl_spiral)
  set(pairs "pcl_spiral/io/:pcl_spiral_io" "io/:pcl_spiral_io" "pcl_spiral/visualization/:pcl_spiral_visualization"
            "visualization/:pcl_spiral_visualization" "pcl/io/:pcl_io"
            "pcl/surface/:pcl_surface" "pcl_spiral/visualization/add_:pcl_visualization"
            "boost/program_options:Boost::program_options" "yaml-cpp/:yaml-cpp" "nlohmann/:nlohmann_json::nlohmann_json" "X11/:X11::X11")
  foreach(module IN LISTS VTK_LIBRARIES) # a header's name does not say its module: all that the project asks for
    list(APPEND pairs "vtk:${module}")
  endforeach()
  foreach(pair IN LISTS pairs)
    string(REGEX MATCH "^([^:]*):(.*)$" pair "${pair}")
    file(STRINGS ${source} found REGEX "#include *[<\"]${CMAKE_MATCH_1}" LIMIT_COUNT 1)
    if(found)
      target_link_libraries(${target} PRIVATE ${CMAKE_MATCH_2})
    endif()
  endforeach()
endfunction()
