# SPDX-License-Identifier: BSD-3-Clause
# Text files as variables of C++: a source file that is made when one of them changes.
# As a script: cmake -DOUTPUT=x.cpp -DNAMESPACE=n "-DTEXTS=name=file|name=|..." -P embedded_texts.cmake; without a file the text is empty.
if(CMAKE_SCRIPT_MODE_FILE)
  string(REPLACE "|" ";" entries "${TEXTS}")
  set(source "namespace ${NAMESPACE} {\n")
  foreach(entry IN LISTS entries)
    string(REGEX MATCH "^([a-z_]+)=(.*)$" matched "${entry}")
    set(name "${CMAKE_MATCH_1}")
    set(file "${CMAKE_MATCH_2}")
    set(text "")
    if(file)
      file(READ "${file}" text)
    endif()
    string(APPEND source "extern const char* const ${name};\nconst char* const ${name} = R\"embedded(${text})embedded\";\n")
  endforeach()
  file(WRITE "${OUTPUT}" "${source}} // namespace ${NAMESPACE}\n")
  return()
endif()

set(pcl_spiral_embedding ${CMAKE_CURRENT_LIST_FILE})

function(pcl_spiral_embed target) # NAME=FILE...: adds a source with these texts to the target
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${target}_texts.cpp)
  set(files)
  foreach(entry IN LISTS ARGN)
    string(REGEX REPLACE "^[a-z_]+=" "" file "${entry}")
    list(APPEND files ${file})
  endforeach()
  string(REPLACE ";" "|" texts "${ARGN}")
  add_custom_command(OUTPUT ${output}
                     COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DNAMESPACE=pcl_spiral "-DTEXTS=${texts}" -P ${pcl_spiral_embedding}
                     DEPENDS ${files} ${pcl_spiral_embedding} VERBATIM)
  target_sources(${target} PRIVATE ${output})
  set_source_files_properties(${output} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
