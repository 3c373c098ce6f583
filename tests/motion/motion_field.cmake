# The motion field: units and pipeline of the RTL against the kernels on corner cases, random triangles and
# places, and on scenes; lint, faults, and what Yosys finds.
halfspace_units_file(motion_low 1 motion_setup motion_field)
halfspace_units_file(motion_middle 4 motion_setup motion_field)
halfspace_units_file(motion_high 16 motion_setup motion_field)
halfspace_cosim_file(pipeline motion_low 16)
halfspace_cosim_file(pipeline motion_middle 4)
halfspace_units_file(motion_gamma 4 motion_setup)
halfspace_cosim_file(pipeline motion_gamma 4)  # affine places and differences: setups of another length
foreach(scene IN ITEMS cube_fast drone)
  halfspace_cosim(pipeline_motion_middle_4_${scene} pipeline motion_middle 4 ${scene} SEEDS 2
                  VECTORS --no-corners --size 160x120 --time 0.7 --interval 0.6:0.7666)
endforeach()
halfspace_lint(lint_motion UNITS motion_setup motion_field CONFIGS motion_low motion_middle motion_high)
halfspace_faults(faults_motion motion motion_middle UNITS motion_setup motion_field)
halfspace_faults(faults_far_ways far_ways motion_middle SCENE rare UNITS motion_field)
