# One configuration with its features taken away (feature_configs.hpp, configs/*.toml): the tops, the units and the pipeline
# of the RTL, what Yosys finds in it, and the cycles of the triangle setup.

file(GLOB tops CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/hls/top/*_top.cpp)
list(FILTER tops EXCLUDE REGEX
     "/(light_vertex|visible_select|shade_setup_lit|phong_setup|shade_phong|texture_setup|shade_texture|motion_setup|motion_field|motion_compensate|scan_object|ztest_merge)_top")  # lighting.cmake, texture.cmake
foreach(config IN ITEMS GouraudOnly FlatDepth FlatOnly Gamma)
  halfspace_tops_test(tops_test_${config} pipeline/tops_test.cpp ${config} formats/feature_configs.hpp ${tops})
  set_target_properties(tops_tops_test_${config} PROPERTIES UNITY_BUILD ON)
endforeach()

foreach(name IN ITEMS gouraud_only flat_depth flat_only gamma gamma_flat)
  halfspace_cosim_file(${name} 4 units)
  halfspace_cosim_file(${name} 1 pipeline)
endforeach()
halfspace_cosim_file(flat_only 4 pipeline)
halfspace_cosim_file(gamma 4 pipeline)
halfspace_cosim_file(gamma 16 pipeline)
halfspace_cosim_file(gamma_odd 2 units)
halfspace_cosim_file(gamma_odd 8 pipeline)
halfspace_cosim_file(gamma_tiny 1 units)
halfspace_cosim_file(gamma_tiny 16 pipeline)

# Whole frames of type γ without stalls: rates and accesses in reference, kernels and RTL, and the cycles of the model.
foreach(lanes IN ITEMS 1 4 16)
  foreach(scene IN ITEMS castle layers)
    add_test(NAME pipeline_gamma_${lanes}_${scene} COMMAND Python3::Interpreter ${cosim_tool} $<TARGET_FILE:halfspace>
             ${CMAKE_CURRENT_BINARY_DIR}/model_pipeline_gamma_${lanes}/bench ${CMAKE_CURRENT_BINARY_DIR}/pipeline_gamma_${lanes}_${scene} ${scene}
             ${config_of_gamma} ${lanes} --stall 0 --seeds 1 --model 0.01 -- --no-corners)
  endforeach()
endforeach()

add_test(NAME faults_flat COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tb/faults/run.py
  --faults ${PROJECT_SOURCE_DIR}/tb/faults/flat.txt --config ${config_of_flat_only}
  --package ${CMAKE_CURRENT_BINARY_DIR}/model_units_flat_only_4/hs_formats_pkg.sv --halfspace $<TARGET_FILE:halfspace>
  --work ${CMAKE_CURRENT_BINARY_DIR}/faults_flat --jobs 2 --library $<TARGET_FILE:halfspace_tb>
  --library $<TARGET_FILE:halfspace_verilated> --verilator ${HALFSPACE_VERILATOR} --cxx ${CMAKE_CXX_COMPILER})
set_tests_properties(faults_flat PROPERTIES PROCESSORS 2 TIMEOUT 1800)

add_test(NAME faults_gamma COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tb/faults/run.py
  --faults ${PROJECT_SOURCE_DIR}/tb/faults/gamma.txt --config ${config_of_gamma}
  --package ${CMAKE_CURRENT_BINARY_DIR}/model_units_gamma_4/hs_formats_pkg.sv --halfspace $<TARGET_FILE:halfspace>
  --work ${CMAKE_CURRENT_BINARY_DIR}/faults_gamma --jobs 2 --library $<TARGET_FILE:halfspace_tb>
  --library $<TARGET_FILE:halfspace_verilated> --verilator ${HALFSPACE_VERILATOR} --cxx ${CMAKE_CXX_COMPILER})
set_tests_properties(faults_gamma PROPERTIES PROCESSORS 2 TIMEOUT 1800)

set(packages "")
foreach(name IN ITEMS gouraud_only flat_depth flat_only gamma gamma_flat)
  list(APPEND packages --package ${CMAKE_CURRENT_BINARY_DIR}/model_pipeline_${name}_1/hs_formats_pkg.sv)
endforeach()
add_test(NAME lint_features COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tb/lint.py --verilator ${HALFSPACE_VERILATOR}
         ${packages})

set(interval_tool ${CMAKE_CURRENT_SOURCE_DIR}/pipeline/interval_test.py)
foreach(name IN ITEMS gouraud_only flat_depth flat_only)
  set(model ${CMAKE_CURRENT_BINARY_DIR}/model_units_${name}_4)
  add_test(NAME interval_${name} COMMAND Python3::Interpreter ${interval_tool} $<TARGET_FILE:halfspace> ${model}/bench
           ${model}/hs_formats_pkg.sv ${config_of_${name}} 4 ${CMAKE_CURRENT_BINARY_DIR}/interval_${name})
endforeach()
add_test(NAME interval_middle COMMAND Python3::Interpreter ${interval_tool} $<TARGET_FILE:halfspace>
         $<TARGET_FILE:tb_units_middle_1> ${PROJECT_SOURCE_DIR}/rtl/formats/middle/hs_formats_pkg.sv middle 1
         ${CMAKE_CURRENT_BINARY_DIR}/interval_middle)

# Multipliers and memories that are left: one multiplier makes the edges, one a depth plane, two the colour planes (their
# factors are cut), six shade; seven memories without a Z-buffer. Type γ: two multipliers more for stored planes, and TdbV, a queue of
# planes, and two of what is in flight.
function(halfspace_features_left name multipliers memories)
  set(package ${CMAKE_CURRENT_BINARY_DIR}/model_pipeline_${name}_1/hs_formats_pkg.sv)
  file(GLOB units CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/rtl/*/hs_*.sv)
  string(REPLACE ";" " " sources "${package};${units}")
  add_test(NAME synthesis_${name} COMMAND ${HALFSPACE_YOSYS} -q -p
    "read_verilog -sv ${sources}; hierarchy -check -top hs_pipeline -chparam LanesX 1 -chparam LanesY 1; proc; opt; check -assert; flatten; opt; memory_collect; select -assert-count ${multipliers} t:$mul; select -assert-count ${memories} t:$mem_v2; select -assert-none t:$div t:$mod")
endfunction()
halfspace_features_left(gouraud_only 9 7)
halfspace_features_left(flat_depth 2 8)
halfspace_features_left(flat_only 1 7)
halfspace_features_left(gamma 12 11)
