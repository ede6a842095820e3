# SPDX-License-Identifier: BSD-3-Clause
# cmake --build BUILD --target doc: the public headers and the pages as HTML in BUILD/doc/html.
find_program(DOXYGEN doxygen)
if(NOT DOXYGEN)
  return()
endif()
add_custom_target(doc COMMAND ${CMAKE_COMMAND} -DDOXYGEN=${DOXYGEN} -DSOURCE_DIR=${PROJECT_SOURCE_DIR}
                              -DOUTPUT_DIR=${PROJECT_BINARY_DIR}/doc -DPROJECT_VERSION=${PROJECT_VERSION}
                              -DPROJECT_DESCRIPTION=${PROJECT_DESCRIPTION}
                              -P ${PROJECT_SOURCE_DIR}/cmake/make_doc.cmake
                  COMMENT "Documenting the public headers" VERBATIM)
