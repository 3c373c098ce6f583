# Frames between key frames: the tops, units and pipeline of the RTL against the kernels on corner cases, random triangles and places, and
# on scenes; lint, faults, and what Yosys finds.
foreach(config IN ITEMS MotionLow MotionMiddle)
  halfspace_tops_test(motion_field_tops_test_${config} motion/motion_field_tops_test.cpp ${config} motion/motion_configs.hpp
                      ${PROJECT_SOURCE_DIR}/hls/top/motion_setup_top.cpp ${PROJECT_SOURCE_DIR}/hls/top/motion_field_top.cpp)
endforeach()
foreach(pair IN ITEMS motion_low-1 motion_middle-4 motion_high-16)
  string(REPLACE "-" ";" pair ${pair})
  list(GET pair 0 name)
  list(GET pair 1 lanes)
  halfspace_cosim_file(${name} ${lanes} motion_units)
endforeach()
halfspace_cosim_file(motion_low 16 pipeline)
halfspace_cosim_file(motion_middle 4 pipeline)
halfspace_cosim_file(motion_gamma 4 pipeline)  # affine places and differences: setups of another length
foreach(scene IN ITEMS cube_fast drone)
  add_test(NAME pipeline_motion_middle_4_${scene} COMMAND Python3::Interpreter ${cosim_tool} $<TARGET_FILE:halfspace>
           ${CMAKE_CURRENT_BINARY_DIR}/model_pipeline_motion_middle_4/bench ${CMAKE_CURRENT_BINARY_DIR}/pipeline_motion_middle_4_${scene} ${scene}
           ${config_of_motion_middle} 4 --stall 30 --seeds 2 -- --no-corners --size 160x120
           --time 0.7 --interval 0.6:0.7666)
endforeach()
add_test(NAME lint_motion COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tb/lint.py --verilator ${HALFSPACE_VERILATOR}
         --package ${CMAKE_CURRENT_BINARY_DIR}/model_motion_units_motion_low_1/hs_formats_pkg.sv
         --package ${CMAKE_CURRENT_BINARY_DIR}/model_motion_units_motion_middle_4/hs_formats_pkg.sv
         --package ${CMAKE_CURRENT_BINARY_DIR}/model_motion_units_motion_high_16/hs_formats_pkg.sv)
add_test(NAME faults_motion COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tb/faults/run.py --top hs_motion_units
  --faults ${PROJECT_SOURCE_DIR}/tb/faults/motion.txt --config ${config_of_motion_middle}
  --package ${CMAKE_CURRENT_BINARY_DIR}/model_motion_units_motion_middle_4/hs_formats_pkg.sv --halfspace $<TARGET_FILE:halfspace>
  --work ${CMAKE_CURRENT_BINARY_DIR}/faults_motion --jobs 2 --library $<TARGET_FILE:halfspace_tb>
  --library $<TARGET_FILE:halfspace_verilated> --verilator ${HALFSPACE_VERILATOR} --cxx ${CMAKE_CXX_COMPILER})
set_tests_properties(faults_motion PROPERTIES PROCESSORS 2 TIMEOUT 1800)
