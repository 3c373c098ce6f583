# Tests on the RTL: benches, co-simulation, lint, faults, what Yosys finds. CONFIG is low, middle, high, or a file of
# configs/ by its stem.

# config_of_NAME: the path of a configuration of configs/, for the command line; low, middle and high are known by their
# names.
file(GLOB configs CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/configs/*/*.toml)
foreach(path IN LISTS configs)
  get_filename_component(name ${path} NAME_WE)
  set(config_of_${name} ${path})
endforeach()
foreach(name IN LISTS HALFSPACE_CONFIGS)
  set(config_of_${name} ${name})
endforeach()

# halfspace_package(CONFIG): sets `package` to the package of a configuration and `package_target` to the target that
# prints it, if any.
function(halfspace_package config)
  set(package_target "" PARENT_SCOPE)
  if(config IN_LIST HALFSPACE_CONFIGS)
    set(package ${PROJECT_SOURCE_DIR}/rtl/formats/${config}/hs_formats_pkg.sv PARENT_SCOPE)
    return()
  endif()
  if(NOT config_of_${config})
    message(FATAL_ERROR "tests/configs: there is no ${config}.toml")
  endif()
  set(folder ${HALFSPACE_BENCHES}/packages/${config})
  if(NOT TARGET package_${config})
    add_custom_command(OUTPUT ${folder}/hs_formats_pkg.sv
      COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
      COMMAND halfspace package --config ${config_of_${config}} -o ${folder}/printed.sv
      # An edited kernel makes another program and the same package: no bench is built again for it.
      COMMAND ${CMAKE_COMMAND} -E copy_if_different ${folder}/printed.sv ${folder}/hs_formats_pkg.sv
      DEPENDS halfspace ${config_of_${config}}
      COMMENT "Package of ${config}.toml" VERBATIM)
    add_custom_target(package_${config} DEPENDS ${folder}/hs_formats_pkg.sv)
    set_target_properties(package_${config} PROPERTIES HALFSPACE_PROGRAM ${folder}/hs_formats_pkg.sv)
  endif()
  set(package ${folder}/hs_formats_pkg.sv PARENT_SCOPE)
  set(package_target package_${config} PARENT_SCOPE)
endfunction()

# halfspace_bench(TOP CONFIG LANES [NETLIST] [PARAMETERS NAME=VALUE …]): sets `bench` to the program and `bench_target`
# to its target, which is added where no test asked for it before. TOP: a unit, or pipeline. Of low, middle and high
# they are those of tb/. NETLIST: of what Yosys makes of the RTL. PARAMETERS: of the module.
function(halfspace_bench top config lanes)
  set(target tb_${top}_${config}_${lanes})
  if("NETLIST" IN_LIST ARGN)
    set(target tb_${top}_netlist_${config}_${lanes})
  endif()
  cmake_parse_arguments(PARSE_ARGV 3 B "NETLIST" "" "PARAMETERS")
  if(B_PARAMETERS)
    string(JOIN _ chosen ${B_PARAMETERS})
    string(REPLACE "=" "" chosen "${chosen}")
    set(target ${target}_${chosen})
  endif()
  if(NOT TARGET ${target})
    halfspace_package(${config})
    set(optimize OPTIMIZE -O0)
    if(config IN_LIST HALFSPACE_CONFIGS)
      set(optimize "")
    endif()
    hs_verilated_model(NAME ${target} TOP hs_${top} PACKAGE ${package} LANES ${lanes} FOLDER ${HALFSPACE_BENCHES}
                       ${optimize} ${ARGN})
    if(package_target)
      add_dependencies(${target} ${package_target})
    endif()
  endif()
  set(bench $<TARGET_FILE:${target}> PARENT_SCOPE)
  set(bench_target ${target} PARENT_SCOPE)
endfunction()

# halfspace_cosim(NAME TOP CONFIG LANES SCENE [NETLIST] [STALL percent] [SEEDS number] [LONG] [OPTIONS of cosim_test.py
# …] [VECTORS options of `halfspace vectors` …] [PARAMETERS NAME=VALUE …]): the RTL against the vectors of a scene.
function(halfspace_cosim name top config lanes scene)
  cmake_parse_arguments(PARSE_ARGV 5 C "NETLIST;LONG" "STALL;SEEDS" "OPTIONS;VECTORS;PARAMETERS")
  if(NOT DEFINED C_STALL)
    set(C_STALL 30)
  endif()
  if(NOT C_SEEDS)
    set(C_SEEDS 1)
  endif()
  set(netlist "")
  if(C_NETLIST)
    set(netlist NETLIST)
  endif()
  set(long "")
  if(C_LONG)
    set(long LONG SECONDS 7200)
  endif()
  set(chosen "")
  if(C_PARAMETERS)
    set(chosen PARAMETERS ${C_PARAMETERS})
  endif()
  halfspace_bench(${top} ${config} ${lanes} ${netlist} ${chosen})
  halfspace_add_test(NAME ${name} WORLD cosim UNITS ${top} ${long} BUILDS halfspace ${bench_target}
    COMMAND $<TARGET_FILE:Python3::Interpreter> ${PROJECT_SOURCE_DIR}/tests/pipeline/cosim_test.py
      $<TARGET_FILE:halfspace> ${bench}
            ${CMAKE_CURRENT_BINARY_DIR}/${name} ${scene} ${config_of_${config}} ${lanes}
            --stall ${C_STALL} --seeds ${C_SEEDS} ${C_OPTIONS} -- ${C_VECTORS})
endfunction()

# halfspace_cosim_file(TOP CONFIG LANES [SCENE]): a configuration that nobody named, under three seeds.
function(halfspace_cosim_file top config lanes)
  set(scene standard)
  if(ARGC GREATER 3)
    set(scene ${ARGV3})
  endif()
  halfspace_cosim(${top}_file_${config}_${lanes} ${top} ${config} ${lanes} ${scene} SEEDS 3)
endfunction()
# halfspace_units_file(CONFIG LANES UNIT …): these units of one.
function(halfspace_units_file config lanes)
  foreach(unit IN LISTS ARGN)
    halfspace_cosim_file(${unit} ${config} ${lanes})
  endforeach()
endfunction()

# halfspace_units_film(CONFIG LANES UNIT …): these units of one that makes films.
function(halfspace_units_film config lanes)
  foreach(unit IN LISTS ARGN)
    halfspace_cosim_file(${unit} ${config} ${lanes} film)
  endforeach()
endfunction()

# halfspace_lint(NAME UNITS unit … CONFIGS config …): lint.py with the packages of these configurations, a test for each
# unit and one for the pipeline.
function(halfspace_lint name)
  cmake_parse_arguments(PARSE_ARGV 1 L "" "" "UNITS;CONFIGS")
  set(units ${L_UNITS} pipeline)
  list(REMOVE_DUPLICATES units)
  set(packages "")
  set(targets "")
  foreach(config IN LISTS L_CONFIGS)
    halfspace_package(${config})
    list(APPEND packages --package ${package})
    list(APPEND targets ${package_target})
  endforeach()
  foreach(unit IN LISTS units)
    halfspace_add_test(NAME ${name}_${unit} WORLD rtl UNITS ${unit} BUILDS ${targets}
      COMMAND $<TARGET_FILE:Python3::Interpreter> ${PROJECT_SOURCE_DIR}/tb/lint.py --verilator ${HALFSPACE_VERILATOR}
              --units ${unit} ${packages})
  endforeach()
endfunction()

# halfspace_faults(NAME FAULTS CONFIG [SCENE scene | WORDS script] [LANES lanes] [LONG] [PARAMETERS NAME=value …]
# UNITS unit …): that the benches of these, with four lanes, find each of tb/faults/FAULTS.txt, on a scene or on the
# words that a script makes; a test for each unit that has faults there, NAME_UNIT, or NAME if it is one alone.
function(halfspace_faults name faults config)
  cmake_parse_arguments(PARSE_ARGV 3 F "LONG" "SCENE;WORDS;LANES" "UNITS;PARAMETERS")
  list(TRANSFORM F_PARAMETERS PREPEND --parameter=)
  set(long "")
  if(F_LONG)
    set(long LONG)
  endif()
  if(NOT F_LANES)
    set(F_LANES 4)
  endif()
  if(NOT F_SCENE)
    set(F_SCENE standard)
  endif()
  halfspace_package(${config})
  set(file ${PROJECT_SOURCE_DIR}/tb/faults/${faults}.txt)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(STRINGS ${file} guilty REGEX "^unit ")
  list(TRANSFORM guilty REPLACE "^unit +([a-z_]+).*" "\\1")
  list(REMOVE_DUPLICATES guilty)
  list(LENGTH guilty number)
  foreach(unit IN LISTS guilty)
    set(test ${name}_${unit})
    if(number EQUAL 1)
      set(test ${name})
    endif()
    set(from --halfspace $<TARGET_FILE:halfspace>)
    if(F_WORDS)
      set(from --words ${CMAKE_CURRENT_SOURCE_DIR}/${F_WORDS})
    endif()
    set(label ${unit})
    if(NOT unit IN_LIST HALFSPACE_UNITS)  # what is round the pipeline
      set(label pipeline)
    endif()
    halfspace_add_test(NAME ${test} WORLD cosim UNITS ${label} SERIAL SECONDS 1800 ${long}
      BUILDS halfspace halfspace_tb halfspace_verilated ${package_target}
      COMMAND $<TARGET_FILE:Python3::Interpreter> ${PROJECT_SOURCE_DIR}/tb/faults/run.py --units ${F_UNITS} --of ${unit}
        --faults ${file} --config ${config_of_${config}} --scene ${F_SCENE} --package ${package}
        --lanes ${F_LANES} ${F_PARAMETERS}
        ${from} --work ${CMAKE_CURRENT_BINARY_DIR}/${test} --jobs 2
        --library $<TARGET_FILE:halfspace_tb> --library $<TARGET_FILE:halfspace_verilated>
        --verilator ${HALFSPACE_VERILATOR} --cxx ${CMAKE_CXX_COMPILER})
  endforeach()
endfunction()

# halfspace_matrix(NAME SCRIPT UNITS unit … [LONG] CASES case … [OPTIONS option …]): a script that makes configurations,
# and benches of them.
function(halfspace_matrix name script)
  cmake_parse_arguments(PARSE_ARGV 2 M "LONG" "" "UNITS;CASES;OPTIONS")
  set(long "")
  if(M_LONG)
    set(long LONG)
  endif()
  halfspace_script_test(${name} ${script} WORLD cosim UNITS ${M_UNITS} ${long} SERIAL SECONDS 7200
    BUILDS halfspace halfspace_tb halfspace_verilated
    COMMAND $<TARGET_FILE:halfspace> ${CMAKE_CURRENT_BINARY_DIR}/${name} ${M_CASES} ${M_OPTIONS} --jobs 2
      --library $<TARGET_FILE:halfspace_tb> --library $<TARGET_FILE:halfspace_verilated>
      --verilator ${HALFSPACE_VERILATOR} --cxx ${CMAKE_CXX_COMPILER})
endfunction()

# halfspace_synthesis(NAME UNIT CONFIG LANES FINDS selection …): Yosys on a unit, or on pipeline; each FINDS is an
# assertion of its command
# `select`.
function(halfspace_synthesis name unit config lanes)
  cmake_parse_arguments(PARSE_ARGV 4 S "" "" "FINDS")
  halfspace_package(${config})
  halfspace_add_test(NAME ${name} WORLD rtl UNITS ${unit} BUILDS ${package_target}
    COMMAND $<TARGET_FILE:Python3::Interpreter> ${PROJECT_SOURCE_DIR}/tests/pipeline/synthesis_test.py
      ${HALFSPACE_YOSYS} ${package}
            hs_${unit} ${lanes} ${S_FINDS})
endfunction()
