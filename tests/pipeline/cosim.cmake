# What is co-simulated of low, middle and high in every run of the tests, and, with label `long`, what takes longer.
# halfspace_units_cosim(CONFIG LANES SCENE SEEDS)
function(halfspace_units_cosim config lanes scene seeds)
  foreach(unit IN LISTS HALFSPACE_UNITS_${config})
    halfspace_cosim(${unit}_${scene}_${config}_${lanes} ${unit} ${config} ${lanes} ${scene} STALL 35 SEEDS ${seeds})
  endforeach()
endfunction()
# Units alone, on corner cases, random frames and small frames of scenes.
halfspace_units_cosim(low 4 standard 10)
halfspace_units_cosim(middle 1 standard 10)
halfspace_units_cosim(middle 16 standard 10)
halfspace_units_cosim(high 4 standard 10)

# A stamp behind one of the frame before.
foreach(lanes IN ITEMS 1 16)
  halfspace_cosim(ztest_index_rare_middle_${lanes} ztest_index middle ${lanes} rare STALL 75 SEEDS 10)
endforeach()

# The pipeline: corner cases and random frames under ten seeds, then whole frames without stalls, where the cycles of a
# frame are held to 1.25 of what the units' rates allow.
function(halfspace_frames_cosim config lanes)
  halfspace_cosim(pipeline_standard_${config}_${lanes} pipeline ${config} ${lanes} standard SEEDS 10)
  foreach(scene teapot castle)
    halfspace_cosim(pipeline_${scene}_${config}_${lanes} pipeline ${config} ${lanes} ${scene} STALL 0
                    OPTIONS --bound 1.25 VECTORS --no-corners)
  endforeach()
endfunction()
halfspace_frames_cosim(low 4)
halfspace_frames_cosim(middle 1)
halfspace_frames_cosim(middle 4)
halfspace_frames_cosim(middle 16)
halfspace_frames_cosim(high 4)
# The largest frame, and the last index behind triangles without area.
halfspace_units_cosim(low 4 largest 2)
halfspace_cosim(pipeline_largest_middle_4 pipeline middle 4 largest SEEDS 2)
halfspace_cosim(pipeline_largest_high_4 pipeline high 4 largest STALL 0)
foreach(scene teapot castle)
  halfspace_cosim(pipeline_${scene}_middle_4_stalls pipeline middle 4 ${scene} SEEDS 10
                  VECTORS --no-corners --size 320x240)
endforeach()
# halfspace_model_cosim(CONFIG FILE …): a scene file.
function(halfspace_model_cosim config file)
  get_filename_component(stem ${file} NAME_WE)
  halfspace_cosim(pipeline_${stem}_${config}_4 pipeline ${config} 4 ${HALFSPACE_TESTMODELS}/${file} ${ARGN})
endfunction()
halfspace_model_cosim(middle OBJ/spider.obj STALL 10 SEEDS 2 VECTORS --no-corners)
halfspace_model_cosim(high glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb STALL 0
                      VECTORS --no-corners --size 640x480)
halfspace_model_cosim(middle Collada/box_nested_animation.dae STALL 10 VECTORS --no-corners --time 1.5)

# The netlist that Yosys makes of the pipeline.
halfspace_cosim(netlist_standard_low_1 pipeline low 1 standard NETLIST)
halfspace_cosim(netlist_standard_middle_4 pipeline middle 4 standard NETLIST)
halfspace_cosim(netlist_standard_high_16 pipeline high 16 standard NETLIST)

# Configurations that nobody named, with the units of low.
halfspace_units_file(odd 4 ${HALFSPACE_UNITS_low})
halfspace_cosim_file(pipeline odd 2)
halfspace_units_file(tiny 1 ${HALFSPACE_UNITS_low})
halfspace_cosim_file(pipeline tiny 16)
halfspace_units_file(wide 8 ${HALFSPACE_UNITS_low})
halfspace_cosim_file(pipeline wide 1)
# The shortest area and the fewest indices; a reciprocal that two factors of 18 bits do not hold.
halfspace_units_file(micro 1 ${HALFSPACE_UNITS_low})
halfspace_cosim_file(pipeline micro 4)
halfspace_units_file(long_reciprocal 1 ${HALFSPACE_UNITS_low})
# A frame of 3104 triangles with 2500 indices.
halfspace_cosim_file(pipeline reuse 4)
halfspace_cosim(pipeline_reuse_castle pipeline reuse 4 castle SEEDS 3 VECTORS --window 64 --random 1)

# Every configuration with every number of lanes, under ten seeds.
foreach(config IN LISTS HALFSPACE_CONFIGS)
  foreach(lanes IN LISTS HALFSPACE_LANES)
    foreach(unit IN LISTS HALFSPACE_UNITS_${config})
      halfspace_cosim(${unit}_standard_${config}_${lanes}_long ${unit} ${config} ${lanes} standard STALL 35
                      SEEDS 10 LONG)
    endforeach()
    foreach(scene IN ITEMS teapot castle)
      halfspace_cosim(pipeline_${scene}_${config}_${lanes}_long pipeline ${config} ${lanes} ${scene} SEEDS 10 LONG
                      VECTORS --no-corners)
    endforeach()
  endforeach()
endforeach()
