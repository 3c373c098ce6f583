# What is co-simulated in every run of the tests, and, with label `long`, what takes longer.
# Units alone, on corner cases, random frames and small frames of scenes.
foreach(pair IN ITEMS low-4 middle-1 middle-16 high-4)
  string(REPLACE "-" ";" pair ${pair})
  list(GET pair 0 config)
  list(GET pair 1 lanes)
  halfspace_cosim(${config} ${lanes} standard TOP units STALL 35 SEEDS 10)
endforeach()

# The pipeline: corner cases and random frames under ten seeds, then whole frames without stalls, where the cycles of a
# frame are held to 1.25 of what the units' rates allow.
foreach(pair IN ITEMS low-4 middle-1 middle-4 middle-16 high-4)
  string(REPLACE "-" ";" pair ${pair})
  list(GET pair 0 config)
  list(GET pair 1 lanes)
  halfspace_cosim(${config} ${lanes} standard STALL 30 SEEDS 10)
  halfspace_cosim(${config} ${lanes} teapot STALL 0 SEEDS 1 BOUND 1.25 VECTORS --no-corners)
  halfspace_cosim(${config} ${lanes} castle STALL 0 SEEDS 1 BOUND 1.25 VECTORS --no-corners)
endforeach()
# The largest frame, and the last index behind triangles without area.
halfspace_cosim(low 4 largest TOP units STALL 35 SEEDS 2)
halfspace_cosim(middle 4 largest STALL 30 SEEDS 2)
halfspace_cosim(high 4 largest STALL 0 SEEDS 1)
halfspace_cosim(middle 4 teapot NAME _stalls STALL 30 SEEDS 10 VECTORS --no-corners --size 320x240)
halfspace_cosim(middle 4 castle NAME _stalls STALL 30 SEEDS 10 VECTORS --no-corners --size 320x240)
halfspace_cosim(middle 4 ${HALFSPACE_TESTMODELS}/OBJ/spider.obj STALL 10 SEEDS 2 VECTORS --no-corners)
halfspace_cosim(high 4 ${HALFSPACE_TESTMODELS}/glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb STALL 0 SEEDS 1
                VECTORS --no-corners --size 640x480)
halfspace_cosim(middle 4 ${HALFSPACE_TESTMODELS}/Collada/box_nested_animation.dae STALL 10 SEEDS 1
                VECTORS --no-corners --time 1.5)

# The netlist that Yosys makes of the pipeline.
halfspace_cosim(low 1 standard TOP netlist STALL 30 SEEDS 1)
halfspace_cosim(middle 4 standard TOP netlist STALL 30 SEEDS 1)
halfspace_cosim(high 16 standard TOP netlist STALL 30 SEEDS 1)

# Configurations that nobody named, from files: the package is printed and the bench built from it, in model_TOP_NAME_LANES; with NETLIST
# from what Yosys makes of the RTL, in netlist_…. LABEL: for tests of that label alone.
function(halfspace_cosim_build name lanes top)
  cmake_parse_arguments(PARSE_ARGV 3 C "NETLIST" "LABEL" "")
  if(NOT C_LABEL)
    set(C_LABEL all)
  endif()
  set(stem model_${top}_${name}_${lanes})
  set(through "")
  if(C_NETLIST)
    set(stem netlist_${top}_${name}_${lanes})
    set(through --yosys ${HALFSPACE_YOSYS})
  endif()
  set(toml ${config_of_${name}})
  set(model ${CMAKE_CURRENT_BINARY_DIR}/${stem})
  file(GLOB units CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/rtl/*/hs_*.sv)
  add_custom_command(OUTPUT ${model}/bench
    COMMAND ${CMAKE_COMMAND} -E make_directory ${model}
    COMMAND halfspace package --config ${toml} -o ${model}/hs_formats_pkg.sv
    COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tb/model.py --package ${model}/hs_formats_pkg.sv --lanes ${lanes}
      --top hs_${top} --out ${model} --library $<TARGET_FILE:halfspace_tb> --library $<TARGET_FILE:halfspace_verilated>
      --verilator ${HALFSPACE_VERILATOR} --cxx ${CMAKE_CXX_COMPILER} --optimize=-O0 ${through}
    DEPENDS halfspace halfspace_tb halfspace_verilated ${toml} ${units} ${PROJECT_SOURCE_DIR}/tb/model.py
    COMMENT "Bench of hs_${top} (${name}.toml, ${lanes} lanes)" VERBATIM)
  add_custom_target(${stem} DEPENDS ${model}/bench)
  add_dependencies(${C_LABEL}_tests ${stem})
endfunction()
# That, and its co-simulation. A fourth argument is another scene than `standard`.
function(halfspace_cosim_file name lanes top)
  set(scene standard)
  if(ARGC GREATER 3)
    set(scene ${ARGV3})
  endif()
  halfspace_cosim_build(${name} ${lanes} ${top})
  set(toml ${config_of_${name}})
  set(model ${CMAKE_CURRENT_BINARY_DIR}/model_${top}_${name}_${lanes})
  add_test(NAME ${top}_file_${name}_${lanes} COMMAND Python3::Interpreter ${cosim_tool} $<TARGET_FILE:halfspace> ${model}/bench
           ${CMAKE_CURRENT_BINARY_DIR}/${top}_file_${name}_${lanes} ${scene} ${toml} ${lanes} --stall 30 --seeds 3)
endfunction()
halfspace_cosim_file(odd 4 units)
halfspace_cosim_file(odd 2 pipeline)
halfspace_cosim_file(tiny 1 units)
halfspace_cosim_file(tiny 16 pipeline)
halfspace_cosim_file(wide 8 units)
halfspace_cosim_file(wide 1 pipeline)

# Every configuration with every number of lanes, under ten seeds.
foreach(config IN LISTS HALFSPACE_CONFIGS)
  foreach(lanes IN LISTS HALFSPACE_LANES)
    halfspace_cosim(${config} ${lanes} standard TOP units NAME _long STALL 35 SEEDS 10 LABEL long)
    foreach(scene IN ITEMS teapot castle)
      halfspace_cosim(${config} ${lanes} ${scene} NAME _long STALL 30 SEEDS 10 LABEL long VECTORS --no-corners)
    endforeach()
  endforeach()
endforeach()
