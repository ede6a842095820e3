# SPDX-License-Identifier: BSD-3-Clause
# Documents a source tree as HTML. Fails if Doxygen has a warning, also for each class, function, member and enumeration
# of a public header without a comment.
# Usage: cmake -DSOURCE_DIR=... -DOUTPUT_DIR=... [-DPROJECT_VERSION=... -DPROJECT_DESCRIPTION=...] -P make_doc.cmake
set(PROJECT_NAME pcl_spiral)
find_program(DOXYGEN doxygen REQUIRED)
file(MAKE_DIRECTORY ${OUTPUT_DIR})
configure_file(${CMAKE_CURRENT_LIST_DIR}/Doxyfile.in ${OUTPUT_DIR}/Doxyfile @ONLY)
set(warnings_file ${OUTPUT_DIR}/warnings.txt)
file(REMOVE ${warnings_file})
execute_process(COMMAND ${DOXYGEN} ${OUTPUT_DIR}/Doxyfile WORKING_DIRECTORY ${OUTPUT_DIR} RESULT_VARIABLE code)
set(warnings "")
if(EXISTS ${warnings_file})
  file(READ ${warnings_file} warnings)
endif()
# Headers in impl may have members without a comment, except the bases of public classes: their members are also public.
string(REGEX REPLACE "/impl/([a-z_]*_input|thread_limit)\\.h" "/impl//\\1.h" warnings "${warnings}")
string(REGEX REPLACE "[^\n]*/impl/[a-z][^\n]* is not documented\\.\n" "" warnings "${warnings}")
if(NOT code EQUAL 0 OR NOT warnings STREQUAL "")
  message("${warnings}")
  message(FATAL_ERROR "Doxygen ended with code ${code}; mend what it warns of (also in ${warnings_file})")
endif()
message(STATUS "Documentation: ${OUTPUT_DIR}/html/index.html")
