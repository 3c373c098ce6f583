# How a test is added: its labels, and what has to be built for it.

# halfspace_add_test(NAME name WORLD world [UNITS unit …] [LONG] [SERIAL] [SECONDS timeout] [BUILDS target …] COMMAND
# word …)
# BUILDS: programs and benches that the command runs. It is not run before each is built; a test says then which target
# builds it.
# SERIAL: it takes two processors.
function(halfspace_add_test)
  cmake_parse_arguments(PARSE_ARGV 0 T "LONG;SERIAL" "NAME;WORLD;SECONDS" "UNITS;BUILDS;COMMAND")
  foreach(unit IN LISTS T_UNITS)
    if(NOT unit IN_LIST HALFSPACE_UNITS)
      message(FATAL_ERROR "test ${T_NAME}: there is no unit ${unit} in hls/units.txt")
    endif()
  endforeach()
  if(NOT T_WORLD IN_LIST HALFSPACE_WORLDS)
    message(FATAL_ERROR "test ${T_NAME}: its WORLD is none of ${HALFSPACE_WORLDS}")
  endif()

  set(needs "")
  foreach(target IN LISTS T_BUILDS)
    get_target_property(file ${target} HALFSPACE_PROGRAM)
    get_target_property(type ${target} TYPE)
    if(file)
      list(APPEND needs ${target}=${file})
    elseif(NOT type STREQUAL "OBJECT_LIBRARY")  # which is compiled and never run
      list(APPEND needs ${target}=$<TARGET_FILE:${target}>)
    endif()
  endforeach()
  if(needs)
    set(T_COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tests/built.py ${PROJECT_BINARY_DIR} ${needs} --
        ${T_COMMAND})
  endif()
  add_test(NAME ${T_NAME} COMMAND ${T_COMMAND})

  set(labels ${T_WORLD} ${T_UNITS})
  set(groups all_tests)
  list(TRANSFORM labels PREPEND tests_ OUTPUT_VARIABLE of_labels)
  list(APPEND groups ${of_labels})
  if(T_LONG)
    list(APPEND labels long)
    set(groups long_tests)
  endif()
  foreach(group IN LISTS groups)
    if(T_BUILDS)
      add_dependencies(${group} ${T_BUILDS})
    endif()
  endforeach()
  set_tests_properties(${T_NAME} PROPERTIES LABELS "${labels}")
  if(T_SECONDS)
    set_tests_properties(${T_NAME} PROPERTIES TIMEOUT ${T_SECONDS})
  endif()
  if(T_SERIAL)
    set_tests_properties(${T_NAME} PROPERTIES PROCESSORS 2)
  endif()
endfunction()

# halfspace_script_test(NAME SCRIPT WORLD world … COMMAND argument …): SCRIPT of the folder, with these arguments.
function(halfspace_script_test name script)
  cmake_parse_arguments(PARSE_ARGV 2 S "" "" "COMMAND")
  halfspace_add_test(NAME ${name} ${S_UNPARSED_ARGUMENTS}
                     COMMAND $<TARGET_FILE:Python3::Interpreter> ${CMAKE_CURRENT_SOURCE_DIR}/${script} ${S_COMMAND})
endfunction()

# The header of all tests, parsed once.
add_library(tests_header OBJECT EXCLUDE_FROM_ALL ${CMAKE_CURRENT_SOURCE_DIR}/header.cpp)
target_link_libraries(tests_header PRIVATE halfspace_study GTest::gtest_main)
target_compile_definitions(tests_header PRIVATE HALFSPACE_SOURCE="${PROJECT_SOURCE_DIR}"
                           HALFSPACE_TESTMODELS="${HALFSPACE_TESTMODELS}")
halfspace_warnings(tests_header)
target_precompile_headers(tests_header PRIVATE <gtest/gtest.h>)

# halfspace_test(NAME WORLD world [UNITS unit …] [LIBRARIES …]): NAME.cpp of the folder as a GoogleTest program.
function(halfspace_test name)
  cmake_parse_arguments(PARSE_ARGV 1 T "" "" "LIBRARIES")
  add_executable(${name} EXCLUDE_FROM_ALL ${name}.cpp)
  target_link_libraries(${name} PRIVATE halfspace_study ${T_LIBRARIES} GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE HALFSPACE_SOURCE="${PROJECT_SOURCE_DIR}"
                             HALFSPACE_TESTMODELS="${HALFSPACE_TESTMODELS}")
  halfspace_warnings(${name})
  target_precompile_headers(${name} REUSE_FROM tests_header)
  halfspace_add_test(NAME ${name} ${T_UNPARSED_ARGUMENTS} BUILDS ${name} COMMAND $<TARGET_FILE:${name}> --gtest_brief=1)
endfunction()
