# Texture: the tops in configurations with each filter and each mapping.
foreach(config IN ITEMS TexturedLow TexturedMiddle TexturedFlat TexturedPhong)
  halfspace_tops_test(texture_tops_test_${config} texture/texture_tops_test.cpp ${config} texture/textured_configs.hpp
                      ${PROJECT_SOURCE_DIR}/hls/top/texture_setup_top.cpp ${PROJECT_SOURCE_DIR}/hls/top/shade_texture_top.cpp)
endforeach()
foreach(pair IN ITEMS textured_low-4 textured_middle-4 textured_phong-1 textured_flat-16)
  string(REPLACE "-" ";" pair ${pair})
  list(GET pair 0 name)
  list(GET pair 1 lanes)
  halfspace_cosim_file(${name} ${lanes} texture_units)
endforeach()
add_test(NAME lint_texture COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tb/lint.py --verilator ${HALFSPACE_VERILATOR}
         --package ${CMAKE_CURRENT_BINARY_DIR}/model_texture_units_textured_low_4/hs_formats_pkg.sv
         --package ${CMAKE_CURRENT_BINARY_DIR}/model_texture_units_textured_middle_4/hs_formats_pkg.sv
         --package ${CMAKE_CURRENT_BINARY_DIR}/model_texture_units_textured_phong_1/hs_formats_pkg.sv)
add_test(NAME faults_texture COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tb/faults/run.py --top hs_texture_units
  --faults ${PROJECT_SOURCE_DIR}/tb/faults/texture.txt --config ${config_of_textured_middle}
  --package ${CMAKE_CURRENT_BINARY_DIR}/model_texture_units_textured_middle_4/hs_formats_pkg.sv --halfspace $<TARGET_FILE:halfspace>
  --work ${CMAKE_CURRENT_BINARY_DIR}/faults_texture --jobs 2 --library $<TARGET_FILE:halfspace_tb>
  --library $<TARGET_FILE:halfspace_verilated> --verilator ${HALFSPACE_VERILATOR} --cxx ${CMAKE_CXX_COMPILER})
set_tests_properties(faults_texture PROPERTIES PROCESSORS 2 TIMEOUT 1800)

# Multipliers: two a plane; perspective, one of the reciprocal and two with it; bilinear, three a channel; three of the product.
# Memories: the table, and the texels in one bank or four.
function(halfspace_texture_left name lanes multipliers memories)
  set(package ${CMAKE_CURRENT_BINARY_DIR}/model_texture_units_${name}_${lanes}/hs_formats_pkg.sv)
  file(GLOB units CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/rtl/*/hs_*.sv)
  string(REPLACE ";" " " sources "${package};${units}")
  add_test(NAME synthesis_${name} COMMAND ${HALFSPACE_YOSYS} -q -p
    "read_verilog -sv ${sources}; hierarchy -check -top hs_shade_texture -chparam LanesX 2 -chparam LanesY 2; proc; opt; check -assert; flatten; opt; memory_collect; select -assert-count ${multipliers} t:$mul; select -assert-count ${memories} t:$mem_v2; select -assert-none t:$div t:$mod")
endfunction()
halfspace_texture_left(textured_low 4 7 2)
halfspace_texture_left(textured_middle 4 21 5)
halfspace_texture_left(textured_phong 1 16 5)
halfspace_texture_left(textured_flat 16 12 2)
