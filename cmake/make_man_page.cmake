# SPDX-License-Identifier: BSD-3-Clause
# Writes the man page of a program, made of its --help.
# Usage: cmake -DPROGRAM=... -DOUTPUT=... -DAWK=... -DVERSION=... "-DOTHERS=PROGRAM ..." -DDOCS=... -P make_man_page.cmake
get_filename_component(name ${PROGRAM} NAME)
string(TIMESTAMP date "%Y-%m-%d" UTC) # that of SOURCE_DATE_EPOCH where it is set
execute_process(COMMAND ${PROGRAM} --help
                COMMAND ${AWK} -v name=${name} -v version=${VERSION} -v date=${date} -v others=${OTHERS} -v docs=${DOCS}
                        -f ${CMAKE_CURRENT_LIST_DIR}/man_page.awk
                OUTPUT_VARIABLE page RESULTS_VARIABLE codes)
if(NOT codes STREQUAL "0;0")
  message(FATAL_ERROR "no man page of ${name}: --help and awk end with ${codes}")
endif()
file(WRITE ${OUTPUT} "${page}")
