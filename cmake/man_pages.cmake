# SPDX-License-Identifier: BSD-3-Clause
# Man pages of the programs, made of what they print for --help when they are built, and installed.
find_program(AWK awk REQUIRED)

# A page of pcl_spiral_NAME names those of the other programs.
function(pcl_spiral_man_page target)
  list(TRANSFORM ARGN PREPEND pcl_spiral_ OUTPUT_VARIABLE others)
  list(JOIN others " " others)
  set(page ${PROJECT_BINARY_DIR}/man/${target}.1)
  add_custom_command(OUTPUT ${page}
                     COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:${target}> -DOUTPUT=${page} -DAWK=${AWK}
                             -DVERSION=${PROJECT_VERSION} "-DOTHERS=${others}" -DDOCS=${CMAKE_INSTALL_DOCDIR}
                             -P ${PROJECT_SOURCE_DIR}/cmake/make_man_page.cmake
                     DEPENDS ${target} ${PROJECT_SOURCE_DIR}/cmake/make_man_page.cmake
                             ${PROJECT_SOURCE_DIR}/cmake/man_page.awk
                     COMMENT "Making the man page of ${target}" VERBATIM)
  add_custom_target(${target}_man ALL DEPENDS ${page})
  add_dependencies(pcl_spiral_programs ${target}_man)
  if(PCL_SPIRAL_INSTALL)
    install(FILES ${page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT programs)
  endif()
endfunction()
