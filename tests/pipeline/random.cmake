# What nobody chose: configurations, scenes, stalls.
set(how --library $<TARGET_FILE:halfspace_tb> --library $<TARGET_FILE:halfspace_verilated>
        --verilator ${HALFSPACE_VERILATOR} --cxx ${CMAKE_CXX_COMPILER})
# halfspace_random_configs(NAME [LONG] [OPTIONS option …]): the first file is a frame of one stamp, in which the faults
# of the test show; the others have a reciprocal that its stride or two factors hardly hold.
function(halfspace_random_configs name)
  cmake_parse_arguments(PARSE_ARGV 1 R "LONG" "" "OPTIONS")
  set(long "")
  if(R_LONG)
    set(long LONG SECONDS 36000)
  endif()
  halfspace_script_test(${name} random_configs_test.py WORLD cosim UNITS pipeline ${long} SERIAL
    BUILDS halfspace halfspace_tb halfspace_verilated
    COMMAND $<TARGET_FILE:halfspace> ${CMAKE_CURRENT_BINARY_DIR}/${name} ${config_of_one_stamp} ${config_of_micro}
            ${config_of_long_gamma} --jobs 2 --yosys ${HALFSPACE_YOSYS} ${how} ${R_OPTIONS})
endfunction()
halfspace_random_configs(random_configs)
halfspace_random_configs(random_configs_long LONG OPTIONS --seed 1000 --count 400 --small 100)
halfspace_cosim_file(pipeline one_stamp 16)

halfspace_script_test(soak soak_test.py WORLD cosim UNITS pipeline
  BUILDS halfspace halfspace_tb halfspace_verilated
  COMMAND $<TARGET_FILE:halfspace> ${CMAKE_CURRENT_BINARY_DIR}/soak ${config_of_micro} ${how})
