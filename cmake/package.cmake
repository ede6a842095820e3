# SPDX-License-Identifier: BSD-3-Clause
# Installs the three targets, the headers, the CMake package, the pkg-config files; CPack makes the .deb.
# Components: libraries (what runs), development (what compiles), programs (with man pages and machine files), documentation, python.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/pcl_spiral)

# A separate export set for each target: a project that uses only the filters does not import VTK.
function(pcl_spiral_install target component description requires)
  if(NOT TARGET ${target})
    return()
  endif()
  install(TARGETS ${target} EXPORT ${target}
          RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT libraries
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT libraries NAMELINK_COMPONENT development
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(EXPORT ${target} FILE pcl_spiral_${component}_targets.cmake NAMESPACE pcl_spiral:: DESTINATION ${package_dir}
          COMPONENT development)

  file(RELATIVE_PATH PC_PREFIX /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
  set(PC_NAME ${target})
  set(PC_DESCRIPTION ${description})
  set(PC_REQUIRES ${requires})
  configure_file(${PROJECT_SOURCE_DIR}/cmake/pcl_spiral.pc.in ${PROJECT_BINARY_DIR}/${target}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${target}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
endfunction()

pcl_spiral_install(pcl_spiral core "${PROJECT_DESCRIPTION}" "pcl_features pcl_filters pcl_search pcl_kdtree eigen3 liblz4")
pcl_spiral_install(pcl_spiral_io io "Readers and writers of pcl_spiral" "pcl_spiral")
pcl_spiral_install(pcl_spiral_visualization visualization "Pictures and viewer of pcl_spiral" "pcl_spiral")

install(DIRECTORY pcl_spiral/include/pcl_spiral DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
install(FILES LICENSE README.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documentation)
if(PCL_SPIRAL_THREE_JS) # it is within the library of io
  install(FILES pcl_spiral/src/io/report/three_licence.txt DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME LICENSE.three.js COMPONENT libraries)
endif()
install(DIRECTORY pcl_spiral/doc DESTINATION ${CMAKE_INSTALL_DOCDIR}/pcl_spiral # where README.md names its pages
        COMPONENT documentation)
install(DIRECTORY examples/machines DESTINATION ${CMAKE_INSTALL_DATADIR}/pcl_spiral COMPONENT programs)

configure_package_config_file(cmake/pcl_spiral-config.cmake.in ${PROJECT_BINARY_DIR}/pcl_spiral-config.cmake
                              INSTALL_DESTINATION ${package_dir} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/pcl_spiral-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/pcl_spiral-config.cmake ${PROJECT_BINARY_DIR}/pcl_spiral-config-version.cmake
              cmake/Findlz4.cmake DESTINATION ${package_dir} COMPONENT development)

if(NOT PROJECT_IS_TOP_LEVEL)
  return() # the parent makes its own package
endif()
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME pcl-spiral)
set(CPACK_PACKAGE_CONTACT "The pcl_spiral authors <pcl_spiral@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libpcl-dev (>= 1.13), libeigen3-dev, liblz4-dev")
find_program(DPKG_SHLIBDEPS dpkg-shlibdeps)
if(DPKG_SHLIBDEPS)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/pcl_spiral)
endif()
if(TARGET pcl_spiral_python) # a package of its own, beside that of all the rest
  set(CPACK_DEB_COMPONENT_INSTALL ON)
  set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
  set(CPACK_DEBIAN_SUITE_PACKAGE_NAME pcl-spiral)
  set(CPACK_DEBIAN_SUITE_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEBIAN_BINDING_PACKAGE_NAME python3-pcl-spiral)
  set(CPACK_DEBIAN_BINDING_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEBIAN_BINDING_PACKAGE_SECTION python)
  math(EXPR next_minor "${Python3_VERSION_MINOR} + 1") # a module is for one version of Python
  set(CPACK_DEBIAN_BINDING_PACKAGE_DEPENDS
      "pcl-spiral (= ${PROJECT_VERSION}), python3-numpy, python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next_minor})")
endif()
include(CPack)
if(TARGET pcl_spiral_python)
  cpack_add_component_group(suite)
  cpack_add_component_group(binding)
  foreach(component libraries development programs documentation)
    cpack_add_component(${component} GROUP suite)
  endforeach()
  cpack_add_component(python GROUP binding)
endif()
