# Tests on the RTL: benches, co-simulation, lint, faults, what Yosys finds. CONFIG is low, middle, high, or a file of configs/ by its stem.

# The units of a bench.
set(units_of_units triangle_setup shade_setup raster_pineda ztest_index ztest_plane scan_index shade_gouraud)
set(units_of_light_units triangle_setup shade_setup light_vertex visible_select)
set(units_of_phong_units phong_setup shade_phong)
set(units_of_texture_units texture_setup shade_texture)
set(units_of_motion_units motion_setup motion_field)
set(units_of_compensate_units motion_compensate)
set(units_of_merge_units ztest_merge)
set(units_of_pipeline pipeline)
set(units_of_netlist pipeline)

# config_of_NAME: the path of a configuration of configs/, for the command line; low, middle and high are known by their names.
file(GLOB configs CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/configs/*/*.toml)
foreach(path IN LISTS configs)
  get_filename_component(name ${path} NAME_WE)
  set(config_of_${name} ${path})
endforeach()
foreach(name IN LISTS HALFSPACE_CONFIGS)
  set(config_of_${name} ${name})
endforeach()

# halfspace_package(CONFIG): sets `package` to the package of a configuration and `package_target` to the target that prints it, if any.
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
      COMMAND halfspace package --config ${config_of_${config}} -o ${folder}/hs_formats_pkg.sv
      DEPENDS halfspace ${config_of_${config}}
      COMMENT "Package of ${config}.toml" VERBATIM)
    add_custom_target(package_${config} DEPENDS ${folder}/hs_formats_pkg.sv)
    set_target_properties(package_${config} PROPERTIES HALFSPACE_PROGRAM ${folder}/hs_formats_pkg.sv)
  endif()
  set(package ${folder}/hs_formats_pkg.sv PARENT_SCOPE)
  set(package_target package_${config} PARENT_SCOPE)
endfunction()

# halfspace_bench(TOP CONFIG LANES [NETLIST]): sets `bench` to the program and `bench_target` to its target, which is added where no test
# asked for it before. Of low, middle and high they are those of tb/. NETLIST: of what Yosys makes of the RTL.
function(halfspace_bench top config lanes)
  if(config IN_LIST HALFSPACE_CONFIGS)
    set(bench $<TARGET_FILE:tb_${top}_${config}_${lanes}> PARENT_SCOPE)
    set(bench_target tb_${top}_${config}_${lanes} PARENT_SCOPE)
    return()
  endif()
  set(target model_${top}_${config}_${lanes})
  set(through "")
  if("NETLIST" IN_LIST ARGN)
    set(target netlist_${top}_${config}_${lanes})
    set(through --yosys ${HALFSPACE_YOSYS})
  endif()
  set(model ${HALFSPACE_BENCHES}/${target})
  halfspace_package(${config})
  if(NOT TARGET ${target})
    file(GLOB units CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/rtl/*/hs_*.sv)
    file(GLOB harness CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tb/*.sv ${PROJECT_SOURCE_DIR}/tb/*.vlt ${PROJECT_SOURCE_DIR}/tb/harness/binding.cpp)
    add_custom_command(OUTPUT ${model}/bench
      COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tb/model.py --package ${package} --lanes ${lanes}
        --top hs_${top} --out ${model} --library $<TARGET_FILE:halfspace_tb> --library $<TARGET_FILE:halfspace_verilated>
        --verilator ${HALFSPACE_VERILATOR} --cxx ${CMAKE_CXX_COMPILER} --optimize=-O0 ${through}
      DEPENDS ${package} ${package_target} halfspace_tb halfspace_verilated ${units} ${harness}
        ${PROJECT_SOURCE_DIR}/tb/model.py ${PROJECT_SOURCE_DIR}/tb/verilate.py
      COMMENT "Bench of hs_${top} (${config}.toml, ${lanes} lanes)" VERBATIM)
    add_custom_target(${target} DEPENDS ${model}/bench)
    set_target_properties(${target} PROPERTIES HALFSPACE_PROGRAM ${model}/bench)
  endif()
  set(bench ${model}/bench PARENT_SCOPE)
  set(bench_target ${target} PARENT_SCOPE)
endfunction()

# halfspace_cosim(NAME TOP CONFIG LANES SCENE [NETLIST] [STALL percent] [SEEDS number] [LONG] [OPTIONS of cosim_test.py …]
# [VECTORS options of `halfspace vectors` …]): the RTL against the vectors of a scene.
function(halfspace_cosim name top config lanes scene)
  cmake_parse_arguments(PARSE_ARGV 5 C "NETLIST;LONG" "STALL;SEEDS" "OPTIONS;VECTORS")
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
  halfspace_bench(${top} ${config} ${lanes} ${netlist})
  halfspace_add_test(NAME ${name} WORLD cosim UNITS ${units_of_${top}} ${long} BUILDS halfspace ${bench_target}
    COMMAND $<TARGET_FILE:Python3::Interpreter> ${PROJECT_SOURCE_DIR}/tests/pipeline/cosim_test.py $<TARGET_FILE:halfspace> ${bench}
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

# halfspace_lint(NAME UNITS unit … CONFIGS config …): lint.py with the packages of these configurations.
function(halfspace_lint name)
  cmake_parse_arguments(PARSE_ARGV 1 L "" "" "UNITS;CONFIGS")
  set(packages "")
  set(targets "")
  foreach(config IN LISTS L_CONFIGS)
    halfspace_package(${config})
    list(APPEND packages --package ${package})
    list(APPEND targets ${package_target})
  endforeach()
  halfspace_add_test(NAME ${name} WORLD rtl UNITS ${L_UNITS} BUILDS ${targets}
    COMMAND $<TARGET_FILE:Python3::Interpreter> ${PROJECT_SOURCE_DIR}/tb/lint.py --verilator ${HALFSPACE_VERILATOR} ${packages})
endfunction()

# halfspace_faults(NAME FAULTS TOP CONFIG [SCENE scene] UNITS unit …): that the bench of TOP with four lanes finds each of tb/faults/FAULTS.txt.
function(halfspace_faults name faults top config)
  cmake_parse_arguments(PARSE_ARGV 4 F "" "SCENE" "UNITS")
  if(NOT F_SCENE)
    set(F_SCENE standard)
  endif()
  halfspace_package(${config})
  halfspace_add_test(NAME ${name} WORLD cosim UNITS ${F_UNITS} SERIAL SECONDS 1800
    BUILDS halfspace halfspace_tb halfspace_verilated ${package_target}
    COMMAND $<TARGET_FILE:Python3::Interpreter> ${PROJECT_SOURCE_DIR}/tb/faults/run.py --top hs_${top}
      --faults ${PROJECT_SOURCE_DIR}/tb/faults/${faults}.txt --config ${config_of_${config}} --scene ${F_SCENE} --package ${package}
      --halfspace $<TARGET_FILE:halfspace> --work ${CMAKE_CURRENT_BINARY_DIR}/${name} --jobs 2 --library $<TARGET_FILE:halfspace_tb>
      --library $<TARGET_FILE:halfspace_verilated> --verilator ${HALFSPACE_VERILATOR} --cxx ${CMAKE_CXX_COMPILER})
endfunction()

# halfspace_matrix(NAME SCRIPT UNITS unit … [LONG] CASES case … [OPTIONS option …]): a script that makes configurations, and benches of them.
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

# halfspace_synthesis(NAME TOP CONFIG UNITS unit … [PARAMETERS name value …] [SOURCES file …] FINDS selection …): Yosys on hs_TOP; each
# FINDS is an assertion of its command `select`.
function(halfspace_synthesis name top config)
  cmake_parse_arguments(PARSE_ARGV 3 S "" "" "UNITS;PARAMETERS;SOURCES;FINDS")
  halfspace_package(${config})
  file(GLOB modules CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/rtl/*/hs_*.sv)
  list(TRANSFORM modules REPLACE "(.+)" "\"\\1\"")
  list(TRANSFORM S_SOURCES REPLACE "(.+)" "\"\\1\"")
  string(JOIN " " sources "\"${package}\"" ${modules} ${S_SOURCES})
  list(TRANSFORM S_PARAMETERS REPLACE "^([A-Z].*)" "-chparam \\1")
  string(JOIN " " parameters ${S_PARAMETERS})
  list(TRANSFORM S_FINDS PREPEND "select ")
  string(JOIN " $<SEMICOLON> " finds ${S_FINDS})
  string(JOIN " $<SEMICOLON> " script "read_verilog -sv ${sources}" "hierarchy -check -top hs_${top} ${parameters}" proc opt
         "check -assert" flatten opt memory_collect ${finds} "select -assert-none t:$div t:$mod")
  halfspace_add_test(NAME ${name} WORLD rtl UNITS ${S_UNITS} BUILDS ${package_target} COMMAND ${HALFSPACE_YOSYS} -q -p ${script})
endfunction()
