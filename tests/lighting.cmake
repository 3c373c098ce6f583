# Configurations with lighting (lit_configs.hpp, configs/lit_*.toml): the top of light_vertex, its RTL against the kernels on
# corner cases, random normals and the normals of scenes, lint, and what Yosys finds in it.
foreach(config IN ITEMS LitHigh LitMatte)
  add_library(tops_${config} OBJECT EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/hls/top/light_vertex_top.cpp)
  set_target_properties(tops_${config} PROPERTIES CXX_STANDARD 14)
  add_executable(light_tops_test_${config} EXCLUDE_FROM_ALL light_tops_test.cpp $<TARGET_OBJECTS:tops_${config}>)
  target_link_libraries(light_tops_test_${config} PRIVATE halfspace_vectors GTest::gtest_main)
  foreach(target IN ITEMS tops_${config} light_tops_test_${config})
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
    target_compile_options(${target} PRIVATE -include ${CMAKE_CURRENT_SOURCE_DIR}/lit_configs.hpp)
    target_compile_definitions(${target} PRIVATE HALFSPACE_TOP_CONFIG=${config})
    halfspace_warnings(${target})
  endforeach()
  add_dependencies(all_tests light_tops_test_${config})
  add_test(NAME light_tops_test_${config} COMMAND light_tops_test_${config} --gtest_brief=1)
endforeach()

set(packages "")
foreach(name IN ITEMS lit_low lit_middle lit_high lit_matte)
  halfspace_cosim_file(${name} 4 light_units)
  list(APPEND packages --package ${CMAKE_CURRENT_BINARY_DIR}/model_light_units_${name}_4/hs_formats_pkg.sv)
endforeach()
add_test(NAME lint_lighting COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tb/lint.py --verilator ${HALFSPACE_VERILATOR}
         ${packages})

add_test(NAME faults_lighting COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tb/faults/run.py --top hs_light_units
  --faults ${PROJECT_SOURCE_DIR}/tb/faults/lighting.txt --config ${CMAKE_CURRENT_SOURCE_DIR}/configs/lit_high.toml
  --package ${CMAKE_CURRENT_BINARY_DIR}/model_light_units_lit_high_4/hs_formats_pkg.sv --halfspace $<TARGET_FILE:halfspace>
  --work ${CMAKE_CURRENT_BINARY_DIR}/faults_lighting --jobs 2 --library $<TARGET_FILE:halfspace_tb>
  --library $<TARGET_FILE:halfspace_verilated> --verilator ${HALFSPACE_VERILATOR} --cxx ${CMAKE_CXX_COMPILER})
set_tests_properties(faults_lighting PROPERTIES PROCESSORS 2 TIMEOUT 1800)

# The normals of scenes.
foreach(pair IN ITEMS lit_low-teapot lit_middle-wheel lit_high-castle lit_high-polyhedron)
  string(REPLACE "-" ";" pair ${pair})
  list(GET pair 0 name)
  list(GET pair 1 scene)
  add_test(NAME light_units_${name}_${scene} COMMAND Python3::Interpreter ${cosim_tool} $<TARGET_FILE:halfspace>
           ${CMAKE_CURRENT_BINARY_DIR}/model_light_units_${name}_4/bench ${CMAKE_CURRENT_BINARY_DIR}/light_units_${name}_${scene} ${scene}
           ${CMAKE_CURRENT_SOURCE_DIR}/configs/${name}.toml 4 --stall 30 --seeds 2 -- --no-corners --size 64x48)
endforeach()

# The netlist that Yosys makes of the unit.
set(netlist ${CMAKE_CURRENT_BINARY_DIR}/model_light_netlist_lit_high_4)
set(package ${CMAKE_CURRENT_BINARY_DIR}/model_light_units_lit_high_4/hs_formats_pkg.sv)
add_custom_command(OUTPUT ${netlist}/bench
  COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tb/model.py --package ${package} --lanes 4 --top hs_light_units --out ${netlist}
    --yosys ${HALFSPACE_YOSYS} --library $<TARGET_FILE:halfspace_tb> --library $<TARGET_FILE:halfspace_verilated>
    --verilator ${HALFSPACE_VERILATOR} --cxx ${CMAKE_CXX_COMPILER} --optimize=-O0
  DEPENDS ${CMAKE_CURRENT_BINARY_DIR}/model_light_units_lit_high_4/bench ${PROJECT_SOURCE_DIR}/tb/model.py
  COMMENT "Bench of the netlist of hs_light_units (lit_high.toml)" VERBATIM)
add_custom_target(model_light_netlist_lit_high_4 DEPENDS ${netlist}/bench)
add_dependencies(model_light_netlist_lit_high_4 model_light_units_lit_high_4)
add_dependencies(all_tests model_light_netlist_lit_high_4)
add_test(NAME light_netlist_lit_high COMMAND Python3::Interpreter ${cosim_tool} $<TARGET_FILE:halfspace> ${netlist}/bench
         ${CMAKE_CURRENT_BINARY_DIR}/light_netlist_lit_high standard ${CMAKE_CURRENT_SOURCE_DIR}/configs/lit_high.toml 4 --stall 30 --seeds 1)

# Multipliers: three a dot product, of which there are |n|² and one or two a light; the root's; a cosine's and a channel's for
# diffuse light and for highlights; the squarings. Memories: the materials, and their exponents.
function(halfspace_lighting_left name multipliers memories)
  set(package ${CMAKE_CURRENT_BINARY_DIR}/model_light_units_${name}_4/hs_formats_pkg.sv)
  file(GLOB units CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/rtl/hs_*.sv)
  string(REPLACE ";" " " sources "${package};${units};${PROJECT_SOURCE_DIR}/tb/hs_light_units.sv")
  add_test(NAME synthesis_${name} COMMAND ${HALFSPACE_YOSYS} -q -p
    "read_verilog -sv ${sources}; hierarchy -check -top hs_light_units; proc; opt; check -assert; flatten; opt; memory_collect; select -assert-count ${multipliers} t:$mul; select -assert-count ${memories} t:$mem_v2; select -assert-none t:$div t:$mod")
endfunction()
halfspace_lighting_left(lit_low 22 2)
halfspace_lighting_left(lit_middle 21 2)
halfspace_lighting_left(lit_high 22 2)
halfspace_lighting_left(lit_matte 11 1)

# Phong shading: the tops, and its units against the kernels.
add_library(tops_PhongLow OBJECT EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/hls/top/phong_setup_top.cpp
  ${PROJECT_SOURCE_DIR}/hls/top/shade_phong_top.cpp)
set_target_properties(tops_PhongLow PROPERTIES CXX_STANDARD 14)
add_executable(phong_tops_test EXCLUDE_FROM_ALL phong_tops_test.cpp $<TARGET_OBJECTS:tops_PhongLow>)
target_link_libraries(phong_tops_test PRIVATE halfspace_vectors GTest::gtest_main)
foreach(target IN ITEMS tops_PhongLow phong_tops_test)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_options(${target} PRIVATE -include ${CMAKE_CURRENT_SOURCE_DIR}/lit_configs.hpp)
  target_compile_definitions(${target} PRIVATE HALFSPACE_TOP_CONFIG=PhongLow)
  halfspace_warnings(${target})
endforeach()
add_dependencies(all_tests phong_tops_test)
add_test(NAME phong_tops_test COMMAND phong_tops_test --gtest_brief=1)
foreach(pair IN ITEMS phong_low-1 phong_low-4 phong_high-4 phong_low-16)
  string(REPLACE "-" ";" pair ${pair})
  list(GET pair 0 name)
  list(GET pair 1 lanes)
  halfspace_cosim_file(${name} ${lanes} phong_units)
endforeach()
foreach(pair IN ITEMS phong_low-teapot phong_high-castle phong_high-polyhedron)
  string(REPLACE "-" ";" pair ${pair})
  list(GET pair 0 name)
  list(GET pair 1 scene)
  add_test(NAME phong_units_${name}_${scene} COMMAND Python3::Interpreter ${cosim_tool} $<TARGET_FILE:halfspace>
           ${CMAKE_CURRENT_BINARY_DIR}/model_phong_units_${name}_4/bench ${CMAKE_CURRENT_BINARY_DIR}/phong_units_${name}_${scene} ${scene}
           ${CMAKE_CURRENT_SOURCE_DIR}/configs/${name}.toml 4 --stall 30 --seeds 2 -- --no-corners --size 128x96)
endforeach()
add_test(NAME lint_phong COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tb/lint.py --verilator ${HALFSPACE_VERILATOR}
         --package ${CMAKE_CURRENT_BINARY_DIR}/model_phong_units_phong_low_4/hs_formats_pkg.sv
         --package ${CMAKE_CURRENT_BINARY_DIR}/model_phong_units_phong_high_4/hs_formats_pkg.sv)
add_test(NAME faults_phong COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tb/faults/run.py --top hs_phong_units
  --faults ${PROJECT_SOURCE_DIR}/tb/faults/phong.txt --config ${CMAKE_CURRENT_SOURCE_DIR}/configs/phong_low.toml
  --package ${CMAKE_CURRENT_BINARY_DIR}/model_phong_units_phong_low_4/hs_formats_pkg.sv --halfspace $<TARGET_FILE:halfspace>
  --work ${CMAKE_CURRENT_BINARY_DIR}/faults_phong --jobs 2 --library $<TARGET_FILE:halfspace_tb>
  --library $<TARGET_FILE:halfspace_verilated> --verilator ${HALFSPACE_VERILATOR} --cxx ${CMAKE_CXX_COMPILER})
set_tests_properties(faults_phong PROPERTIES PROCESSORS 2 TIMEOUT 1800)
