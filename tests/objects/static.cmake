# The static objects buffer by the kernels.
halfspace_test(merge_test)
halfspace_test(static_kernel_test)
foreach(config IN ITEMS ObjectsLow ObjectsMiddle ObjectsHigh)
  halfspace_tops_test(merge_tops_test_${config} objects/merge_tops_test.cpp ${config} objects/object_configs.hpp
                      ${PROJECT_SOURCE_DIR}/hls/top/ztest_merge_top.cpp ${PROJECT_SOURCE_DIR}/hls/top/scan_object_top.cpp)
endforeach()
# Whole sequences on the RTL: with one S-buffer, with three, in several passes and with index reuse, and lit; the lanes of the benches that
# there are, and two of ztest_merge more.
halfspace_cosim_build(objects_tiny 1 merge_units)
halfspace_cosim_build(objects_lit 4 merge_units)
# halfspace_static_cosim(NAME CONFIG LANES [option …] -- [option of `vectors static` …])
function(halfspace_static_cosim name config lanes)
  add_test(NAME static_cosim_${name} COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/objects/static_cosim_test.py $<TARGET_FILE:halfspace>
    ${CMAKE_CURRENT_BINARY_DIR}/model_pipeline_${config}_${lanes}/bench ${CMAKE_CURRENT_BINARY_DIR}/model_merge_units_${config}_${lanes}/bench
    ${CMAKE_CURRENT_BINARY_DIR}/static_cosim_${name} ${config_of_${config}} ${lanes} ${ARGN})
endfunction()
halfspace_static_cosim(one objects_low 4 --stall 30 -- --frames 2000)
halfspace_static_cosim(three objects_low 4 --stall 0 --seed 2 -- --frames 1000 --buffers 3 --objects 14)
halfspace_static_cosim(box objects_low 4 --stall 20 --seed 3 -- --frames 500 --buffers 3 --no-query --size 37x23 --window 5)
halfspace_static_cosim(passes objects_tiny 1 --stall 20 --seed 4 -- --frames 600 --objects 16)
halfspace_static_cosim(reuse objects_tiny 1 --stall 10 --seed 5 -- --frames 600 --objects 16 --buffers 2 --window 3)
halfspace_static_cosim(lit objects_lit 4 --stall 20 --seed 6 -- --frames 400)
