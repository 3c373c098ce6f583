# Configurations with lighting (lit_configs.hpp, configs/lit_*.toml, phong_*.toml): the tops, units and pipeline of the RTL against
# the kernels on corner cases, random triangles and normals and on scenes, lint, and what Yosys finds.
foreach(config IN ITEMS LitHigh LitMatte)
  halfspace_tops_test(light_tops_test_${config} shade/light_tops_test.cpp ${config} shade/lit_configs.hpp
                      ${PROJECT_SOURCE_DIR}/hls/top/light_vertex_top.cpp ${PROJECT_SOURCE_DIR}/hls/top/visible_select_top.cpp
                      ${PROJECT_SOURCE_DIR}/hls/top/shade_setup_lit_top.cpp)
endforeach()

set(packages "")
foreach(name IN ITEMS lit_low lit_middle lit_high lit_matte)
  halfspace_cosim_file(${name} 4 light_units)
  list(APPEND packages --package ${CMAKE_CURRENT_BINARY_DIR}/model_light_units_${name}_4/hs_formats_pkg.sv)
endforeach()
add_test(NAME lint_lighting COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tb/lint.py --verilator ${HALFSPACE_VERILATOR}
         ${packages})

add_test(NAME faults_lighting COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tb/faults/run.py --top hs_light_units
  --faults ${PROJECT_SOURCE_DIR}/tb/faults/lighting.txt --config ${config_of_lit_high}
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
           ${config_of_${name}} 4 --stall 30 --seeds 2 -- --no-corners --size 64x48)
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
         ${CMAKE_CURRENT_BINARY_DIR}/light_netlist_lit_high standard ${config_of_lit_high} 4 --stall 30 --seeds 1)

# Multipliers: three a dot product, of which there are |n|² and one or two a light; the root's; a cosine's and a channel's for
# diffuse light and for highlights; the squarings. Memories: the materials, and their exponents.
function(halfspace_lighting_left name vertices multipliers memories)
  set(package ${CMAKE_CURRENT_BINARY_DIR}/model_light_units_${name}_4/hs_formats_pkg.sv)
  file(GLOB units CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/rtl/*/hs_*.sv)
  string(REPLACE ";" " " sources "${package};${units}")
  add_test(NAME synthesis_${name} COMMAND ${HALFSPACE_YOSYS} -q -p
    "read_verilog -sv ${sources}; hierarchy -check -top hs_light_vertex -chparam Vertices ${vertices}; proc; opt; check -assert; flatten; opt; memory_collect; select -assert-count ${multipliers} t:$mul; select -assert-count ${memories} t:$mem_v2; select -assert-none t:$div t:$mod")
endfunction()
halfspace_lighting_left(lit_low 3 22 2)
halfspace_lighting_left(lit_middle 3 21 2)
halfspace_lighting_left(lit_high 3 22 2)
halfspace_lighting_left(lit_matte 1 11 1)

# Phong shading: the tops, and its units against the kernels.
halfspace_tops_test(phong_tops_test shade/phong_tops_test.cpp PhongLow shade/lit_configs.hpp
                    ${PROJECT_SOURCE_DIR}/hls/top/phong_setup_top.cpp ${PROJECT_SOURCE_DIR}/hls/top/shade_phong_top.cpp)
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
           ${config_of_${name}} 4 --stall 30 --seeds 2 -- --no-corners --size 128x96)
endforeach()
add_test(NAME lint_phong COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tb/lint.py --verilator ${HALFSPACE_VERILATOR}
         --package ${CMAKE_CURRENT_BINARY_DIR}/model_phong_units_phong_low_4/hs_formats_pkg.sv
         --package ${CMAKE_CURRENT_BINARY_DIR}/model_phong_units_phong_high_4/hs_formats_pkg.sv)
add_test(NAME faults_phong COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tb/faults/run.py --top hs_phong_units
  --faults ${PROJECT_SOURCE_DIR}/tb/faults/phong.txt --config ${config_of_phong_low}
  --package ${CMAKE_CURRENT_BINARY_DIR}/model_phong_units_phong_low_4/hs_formats_pkg.sv --halfspace $<TARGET_FILE:halfspace>
  --work ${CMAKE_CURRENT_BINARY_DIR}/faults_phong --jobs 2 --library $<TARGET_FILE:halfspace_tb>
  --library $<TARGET_FILE:halfspace_verilated> --verilator ${HALFSPACE_VERILATOR} --cxx ${CMAKE_CXX_COMPILER})
set_tests_properties(faults_phong PROPERTIES PROCESSORS 2 TIMEOUT 1800)
