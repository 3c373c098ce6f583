# Pixels that know their objects: the pipeline with scan_object, and ztest_merge, both against the kernels, on corner cases, random triangles
# and buffers; without stalls to the cycle; lint, faults, and what Yosys finds.
foreach(pair IN ITEMS objects_low-4 objects_middle-4 objects_middle-16 objects_tiny-1 objects_flat-4 objects_lit-4)
  string(REPLACE "-" ";" pair ${pair})
  list(GET pair 0 name)
  list(GET pair 1 lanes)
  halfspace_cosim_file(${name} ${lanes} pipeline)
endforeach()
halfspace_cosim_build(objects_middle 1 pipeline)
add_test(NAME pipeline_objects_middle_1 COMMAND Python3::Interpreter ${cosim_tool} $<TARGET_FILE:halfspace>
         ${CMAKE_CURRENT_BINARY_DIR}/model_pipeline_objects_middle_1/bench ${CMAKE_CURRENT_BINARY_DIR}/pipeline_objects_middle_1 standard
         ${config_of_objects_middle} 1 --stall 30 --seeds 1)  # the most words: one seed
foreach(pair IN ITEMS objects_low-4 objects_middle-1 objects_high-16)
  string(REPLACE "-" ";" pair ${pair})
  list(GET pair 0 name)
  list(GET pair 1 lanes)
  halfspace_cosim_file(${name} ${lanes} merge_units merge)
  set(model ${CMAKE_CURRENT_BINARY_DIR}/model_merge_units_${name}_${lanes})
  add_test(NAME merge_units_cycles_${name}_${lanes} COMMAND Python3::Interpreter ${cosim_tool} $<TARGET_FILE:halfspace> ${model}/bench
           ${CMAKE_CURRENT_BINARY_DIR}/merge_units_cycles_${name}_${lanes} merge ${config_of_${name}} ${lanes}
           --stall 0 --seeds 1)
endforeach()

# halfspace_object_frames(CONFIG LANES SCENE [options of cosim_test.py …]): whole frames without stalls.
function(halfspace_object_frames name lanes scene)
  add_test(NAME pipeline_${name}_${lanes}_${scene} COMMAND Python3::Interpreter ${cosim_tool} $<TARGET_FILE:halfspace>
           ${CMAKE_CURRENT_BINARY_DIR}/model_pipeline_${name}_${lanes}/bench ${CMAKE_CURRENT_BINARY_DIR}/pipeline_${name}_${lanes}_${scene} ${scene}
           ${config_of_${name}} ${lanes} --stall 0 --seeds 1 ${ARGN})
endfunction()
# Rates and accesses in reference, kernels and RTL, and the cycles of the model, which knows of no objects: they cost none.
halfspace_object_frames(objects_low 4 castle --bound 1.25 -- --no-corners)
# A pixel a cycle sets the pace: the queue before scan_object has to hold all that is on its way through the longest shader.
halfspace_cosim_build(objects_phong 1 pipeline)
halfspace_object_frames(objects_phong 1 teapot --bound 1.01 -- --no-corners)
halfspace_cosim_build(objects_low 1 pipeline)
halfspace_object_frames(objects_low 1 teapot --bound 1.01 -- --no-corners)

# Indices of invisible triangles are used again: the table has the object of the last triangle of an index.
add_test(NAME pipeline_objects_low_4_reuse COMMAND Python3::Interpreter ${cosim_tool} $<TARGET_FILE:halfspace>
         ${CMAKE_CURRENT_BINARY_DIR}/model_pipeline_objects_low_4/bench ${CMAKE_CURRENT_BINARY_DIR}/pipeline_objects_low_4_reuse castle
         ${config_of_objects_low} 4 --stall 30 --seeds 1 -- --window 64 --random 1)

set(packages "")
foreach(model IN ITEMS pipeline_objects_low_4 pipeline_objects_flat_4 pipeline_objects_phong_1)
  list(APPEND packages --package ${CMAKE_CURRENT_BINARY_DIR}/model_${model}/hs_formats_pkg.sv)
endforeach()
add_test(NAME lint_objects COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tb/lint.py --verilator ${HALFSPACE_VERILATOR} ${packages})
foreach(pair IN ITEMS objects-pipeline-standard merge-merge_units-merge)
  string(REPLACE "-" ";" pair ${pair})
  list(GET pair 0 faults)
  list(GET pair 1 top)
  list(GET pair 2 scene)
  add_test(NAME faults_${faults} COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tb/faults/run.py --top hs_${top}
    --faults ${PROJECT_SOURCE_DIR}/tb/faults/${faults}.txt --config ${config_of_objects_low} --scene ${scene}
    --package ${CMAKE_CURRENT_BINARY_DIR}/model_${top}_objects_low_4/hs_formats_pkg.sv --halfspace $<TARGET_FILE:halfspace>
    --work ${CMAKE_CURRENT_BINARY_DIR}/faults_${faults} --jobs 2 --library $<TARGET_FILE:halfspace_tb>
    --library $<TARGET_FILE:halfspace_verilated> --verilator ${HALFSPACE_VERILATOR} --cxx ${CMAKE_CXX_COMPILER})
  set_tests_properties(faults_${faults} PROPERTIES PROCESSORS 2 TIMEOUT 1800)
endforeach()

# Objects bring no multiplier to the 11 of the pipeline, and three memories to its 8: the second bank of the Z-buffer, the object table, a queue. ztest_merge
# has neither.
halfspace_features_left(objects_middle 11 11)
set(package ${CMAKE_CURRENT_BINARY_DIR}/model_merge_units_objects_low_4/hs_formats_pkg.sv)
file(GLOB units CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/rtl/*/hs_*.sv)
string(REPLACE ";" " " sources "${package};${units}")
add_test(NAME synthesis_ztest_merge COMMAND ${HALFSPACE_YOSYS} -q -p
  "read_verilog -sv ${sources}; hierarchy -check -top hs_ztest_merge -chparam LanesX 2 -chparam LanesY 2; proc; opt; check -assert; flatten; opt; memory_collect; select -assert-none t:$mul t:$mem_v2 t:$div t:$mod; select -assert-min 1 t:$lt")

# The netlists that Yosys makes of both; that of the pipeline, which is simulated more slowly, with label `long`.
halfspace_cosim_build(objects_low 4 merge_units NETLIST)
halfspace_cosim_build(objects_low 4 pipeline NETLIST LABEL long)
foreach(top IN ITEMS merge_units pipeline)
  set(scene standard)
  if(top STREQUAL "merge_units")
    set(scene merge)
  endif()
  add_test(NAME ${top}_netlist_objects_low_4 COMMAND Python3::Interpreter ${cosim_tool} $<TARGET_FILE:halfspace>
           ${CMAKE_CURRENT_BINARY_DIR}/netlist_${top}_objects_low_4/bench ${CMAKE_CURRENT_BINARY_DIR}/${top}_netlist_objects_low_4 ${scene}
           ${config_of_objects_low} 4 --stall 30 --seeds 1)
endforeach()
set_tests_properties(pipeline_netlist_objects_low_4 PROPERTIES LABELS long TIMEOUT 7200)
