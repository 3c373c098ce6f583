# motion_compensate: its top in three configurations, its bench with each filter, without stalls to the cycle, and faults in it.
foreach(config IN ITEMS MotionLow MotionMiddle MotionHigh)
  halfspace_tops_test(compensate_tops_test_${config} motion/compensate_tops_test.cpp ${config} motion/motion_configs.hpp
                      ${PROJECT_SOURCE_DIR}/hls/top/motion_compensate_top.cpp)
endforeach()
set(packages "")
foreach(name IN ITEMS motion_low motion_middle motion_high motion_area motion_cubic motion_tiny)
  halfspace_cosim_file(${name} 4 compensate_units compensation)
  set(model ${CMAKE_CURRENT_BINARY_DIR}/model_compensate_units_${name}_4)
  add_test(NAME compensate_units_cycles_${name} COMMAND Python3::Interpreter ${cosim_tool} $<TARGET_FILE:halfspace> ${model}/bench
           ${CMAKE_CURRENT_BINARY_DIR}/compensate_units_cycles_${name} compensation ${config_of_${name}} 4
           --stall 0 --seeds 1)
  list(APPEND packages --package ${model}/hs_formats_pkg.sv)
endforeach()
add_test(NAME lint_compensate COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tb/lint.py --verilator ${HALFSPACE_VERILATOR} ${packages})
add_test(NAME faults_compensate COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tb/faults/run.py --top hs_compensate_units
  --faults ${PROJECT_SOURCE_DIR}/tb/faults/compensate.txt --config ${config_of_motion_high} --scene compensation
  --package ${CMAKE_CURRENT_BINARY_DIR}/model_compensate_units_motion_high_4/hs_formats_pkg.sv --halfspace $<TARGET_FILE:halfspace>
  --work ${CMAKE_CURRENT_BINARY_DIR}/faults_compensate --jobs 2 --library $<TARGET_FILE:halfspace_tb>
  --library $<TARGET_FILE:halfspace_verilated> --verilator ${HALFSPACE_VERILATOR} --cxx ${CMAKE_CXX_COMPILER})
set_tests_properties(faults_compensate PROPERTIES PROCESSORS 2 TIMEOUT 1800)

# Multipliers: of each key and channel 3 for two by two pixels and 15 for four by four, and one of each channel's blend. Memories: of
# each key a bank for each pixel of a block.
function(halfspace_compensate_left name multipliers memories)
  set(package ${CMAKE_CURRENT_BINARY_DIR}/model_compensate_units_${name}_4/hs_formats_pkg.sv)
  file(GLOB units CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/rtl/*/hs_*.sv)
  string(REPLACE ";" " " sources "${package};${units};${PROJECT_SOURCE_DIR}/tb/hs_compensate_units.sv")
  add_test(NAME synthesis_compensate_${name} COMMAND ${HALFSPACE_YOSYS} -q -p
    "read_verilog -sv ${sources}; hierarchy -check -top hs_compensate_units; proc; opt; check -assert; flatten; opt; memory_collect; select -assert-count ${multipliers} t:$mul; select -assert-count ${memories} t:$mem_v2; select -assert-none t:$div t:$mod")
endfunction()
halfspace_compensate_left(motion_low 3 8)
halfspace_compensate_left(motion_middle 21 8)
halfspace_compensate_left(motion_high 93 32)

# The netlist of one with each kind of filter; and, with label `long`, each filter in each size with 1 and 4 samples.
function(halfspace_compensate_matrix name)
  add_test(NAME ${name} COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/motion/compensate_matrix_test.py $<TARGET_FILE:halfspace>
    ${CMAKE_CURRENT_BINARY_DIR}/${name} ${ARGN} --jobs 2 --library $<TARGET_FILE:halfspace_tb> --library $<TARGET_FILE:halfspace_verilated>
    --verilator ${HALFSPACE_VERILATOR} --yosys ${HALFSPACE_YOSYS} --cxx ${CMAKE_CXX_COMPILER})
  set_tests_properties(${name} PROPERTIES PROCESSORS 2 TIMEOUT 7200)
endfunction()
halfspace_compensate_matrix(compensate_netlist low-nearest-4-netlist middle-area-1-netlist high-bicubic-4-netlist)
set(all "")
foreach(size IN ITEMS low middle high)
  foreach(filter IN ITEMS nearest bilinear area bicubic)
    list(APPEND all ${size}-${filter}-1 ${size}-${filter}-4)
  endforeach()
endforeach()
halfspace_compensate_matrix(compensate_matrix_long ${all})
set_tests_properties(compensate_matrix_long PROPERTIES LABELS long)
