# The kernels on the numbers of libraries (docs/types.md): each library that is at hand has programs of its own.
set(HALFSPACE_AP_TYPES "" CACHE PATH "Folder of Xilinx's ap_fixed.h, for the tests on its numbers")
set(HALFSPACE_AC_TYPES "" CACHE PATH "Folder of Siemens' ac_fixed.h and ac_channel.h, for the tests on its numbers")

# halfspace_types(NAME [option …]): the tests on the numbers of halfspace_types_NAME, with options for the compiler.
function(halfspace_types name)
  # Operators of hundreds of formats, each used a few hundred times: compiling is what costs.
  add_executable(types_test_${name} EXCLUDE_FROM_ALL types_test.cpp)
  target_compile_options(types_test_${name} PRIVATE -O0)
  add_executable(fixed_test_${name} EXCLUDE_FROM_ALL fixed_test.cpp)
  foreach(test types_test fixed_test)
    target_link_libraries(${test}_${name} PRIVATE GTest::gtest_main halfspace_hls halfspace_types_${name})
    add_test(NAME ${test}_${name} COMMAND ${test}_${name} --gtest_brief=1)
  endforeach()

  add_library(types_engine_${name} OBJECT EXCLUDE_FROM_ALL types_engine.cpp)
  target_link_libraries(types_engine_${name} PUBLIC halfspace_vectors halfspace_types_${name})
  add_executable(types_run_${name} EXCLUDE_FROM_ALL types_run.cpp)
  target_link_libraries(types_run_${name} PRIVATE types_engine_${name} nlohmann_json::nlohmann_json)
  target_compile_options(types_engine_${name} PRIVATE -O2)
  add_test(NAME types_run_${name} COMMAND types_run_${name} ${PROJECT_SOURCE_DIR}/vectors/standard
           ${CMAKE_CURRENT_BINARY_DIR}/types_${name})

  # The tops as a synthesis tool compiles them, but with run-time types, which SystemC and hls_stream.h ask for.
  get_target_property(tops halfspace_tops SOURCES)
  list(TRANSFORM tops PREPEND ${PROJECT_SOURCE_DIR}/hls/)
  add_library(types_tops_${name} OBJECT EXCLUDE_FROM_ALL ${tops})
  set_target_properties(types_tops_${name} PROPERTIES CXX_STANDARD 14)
  target_link_libraries(types_tops_${name} PRIVATE halfspace_types_${name})
  target_compile_options(types_tops_${name} PRIVATE -fno-exceptions)

  foreach(target types_test_${name} fixed_test_${name} types_engine_${name} types_run_${name} types_tops_${name})
    halfspace_warnings(${target})
    target_compile_options(${target} PRIVATE ${ARGN})
    add_dependencies(all_tests ${target})
  endforeach()
endfunction()

pkg_check_modules(SYSTEMC REQUIRED IMPORTED_TARGET systemc)
add_library(types_sc_main OBJECT EXCLUDE_FROM_ALL types_sc_main.cpp)
add_library(halfspace_types_systemc INTERFACE)
target_compile_definitions(halfspace_types_systemc INTERFACE HALFSPACE_TYPES_SYSTEMC)
target_link_libraries(halfspace_types_systemc INTERFACE PkgConfig::SYSTEMC $<TARGET_OBJECTS:types_sc_main>)
halfspace_types(systemc)

# halfspace_types_of_folder(NAME HEADER [option …]): the same for headers in the folder HALFSPACE_NAME_TYPES.
function(halfspace_types_of_folder name header)
  string(TOUPPER ${name} upper)
  set(folder ${HALFSPACE_${upper}_TYPES})
  if(NOT folder)
    message(STATUS "No tests on ${header}: give its folder by -DHALFSPACE_${upper}_TYPES=FOLDER (docs/types.md)")
  elseif(NOT EXISTS ${folder}/${header})
    message(FATAL_ERROR "HALFSPACE_${upper}_TYPES: there is no ${header} in ${folder}: name the folder that holds it")
  else()
    add_library(halfspace_types_${name} INTERFACE)
    target_compile_definitions(halfspace_types_${name} INTERFACE HALFSPACE_TYPES_${upper})
    target_include_directories(halfspace_types_${name} SYSTEM INTERFACE ${folder})
    halfspace_types(${name} ${ARGN})
  endif()
endfunction()
# ap_fixed.h copies fields before they have a value.
halfspace_types_of_folder(ap ap_fixed.h -Wno-uninitialized -Wno-maybe-uninitialized)
if(TARGET types_tops_ap AND EXISTS ${HALFSPACE_AP_TYPES}/hls_stream.h)
  target_compile_definitions(types_tops_ap PRIVATE HALFSPACE_STREAM_HLS)
  target_compile_options(types_tops_ap PRIVATE -Wno-unknown-pragmas)
endif()
halfspace_types_of_folder(ac ac_fixed.h)
if(TARGET types_tops_ac AND EXISTS ${HALFSPACE_AC_TYPES}/ac_channel.h)
  target_compile_definitions(types_tops_ac PRIVATE HALFSPACE_STREAM_AC)
endif()

# The same frame on each kind of numbers. The objects alone: the benchmark itself is on none of them.
add_executable(types_benchmark EXCLUDE_FROM_ALL types_benchmark.cpp $<TARGET_OBJECTS:types_engine_systemc>
               $<TARGET_OBJECTS:types_sc_main>)
target_link_libraries(types_benchmark PRIVATE halfspace_vectors benchmark::benchmark PkgConfig::SYSTEMC)
foreach(name ap ac)
  if(TARGET types_engine_${name})
    string(TOUPPER ${name} macro)
    target_compile_definitions(types_benchmark PRIVATE HALFSPACE_BENCHMARK_${macro})
    target_sources(types_benchmark PRIVATE $<TARGET_OBJECTS:types_engine_${name}>)
  endif()
endforeach()
halfspace_warnings(types_benchmark)
