# The pipeline with scan_object, and ztest_merge, both against the kernels, on corner cases, random triangles
# and buffers; without stalls to the cycle; lint, faults, and what Yosys finds.
halfspace_cosim_file(pipeline objects_low 4)
halfspace_cosim_file(pipeline objects_middle 4)
halfspace_cosim_file(pipeline objects_middle 16)
halfspace_cosim_file(pipeline objects_tiny 1)
halfspace_cosim_file(pipeline objects_flat 4)
halfspace_cosim_file(pipeline objects_lit 4)
halfspace_cosim(pipeline_objects_middle_1 pipeline objects_middle 1 standard)  # the most words: one seed
function(halfspace_merge config lanes)
  halfspace_cosim_file(ztest_merge ${config} ${lanes} merge)
  halfspace_cosim(ztest_merge_cycles_${config}_${lanes} ztest_merge ${config} ${lanes} merge STALL 0)
endfunction()
halfspace_merge(objects_low 4)
halfspace_merge(objects_middle 1)
halfspace_merge(objects_high 16)

# Whole frames without stalls. Rates and accesses in reference, kernels and RTL, and the cycles of the model, which
# knows of no objects: they cost none. A pixel a cycle sets the pace: the queue before scan_object has to hold all that
# is on its way through the longest shader.
halfspace_cosim(pipeline_objects_low_4_castle pipeline objects_low 4 castle STALL 0 OPTIONS --bound 1.25
                VECTORS --no-corners)
halfspace_cosim(pipeline_objects_phong_1_teapot pipeline objects_phong 1 teapot STALL 0 OPTIONS --bound 1.01
                VECTORS --no-corners)
halfspace_cosim(pipeline_objects_low_1_teapot pipeline objects_low 1 teapot STALL 0 OPTIONS --bound 1.01
                VECTORS --no-corners)
# Indices of invisible triangles are used again: the table has the object of the last triangle of an index.
halfspace_cosim(pipeline_objects_low_4_reuse pipeline objects_low 4 castle VECTORS --window 64 --random 1)

halfspace_lint(lint_objects UNITS scan_object ztest_merge pipeline CONFIGS objects_low objects_flat objects_phong)
halfspace_faults(faults_objects objects objects_low UNITS pipeline)
halfspace_faults(faults_merge merge objects_low SCENE merge UNITS ztest_merge)
# A frame with more rows than columns, a pixel a stamp.
halfspace_cosim_file(pipeline objects_tall 1)
halfspace_faults(faults_tall edges/tall objects_tall SCENE merge LANES 1 UNITS ztest_merge)

# Objects bring no multiplier to the 11 of the pipeline, and three memories to its 8: the second bank of the Z-buffer,
# the object table, a queue. ztest_merge has neither.
halfspace_synthesis(synthesis_objects_middle pipeline objects_middle 1
                    FINDS "-assert-count 11 t:$mul" "-assert-count 11 t:$mem_v2")
halfspace_synthesis(synthesis_ztest_merge ztest_merge objects_low 4
                    FINDS "-assert-none t:$mul t:$mem_v2" "-assert-min 1 t:$lt")

# The netlists that Yosys makes of both; that of the pipeline, which is simulated more slowly, with label `long`.
halfspace_cosim(ztest_merge_netlist_objects_low_4 ztest_merge objects_low 4 merge NETLIST)
halfspace_cosim(pipeline_netlist_objects_low_4 pipeline objects_low 4 standard NETLIST LONG)
