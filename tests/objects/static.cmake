# Whole sequences on the RTL: with one S-buffer, with three, in several passes and with index reuse, and lit.
# halfspace_static_cosim(NAME CONFIG LANES [option …] -- [option of `vectors static` …])
function(halfspace_static_cosim name config lanes)
  halfspace_bench(pipeline ${config} ${lanes})
  set(pipeline ${bench})
  set(pipeline_target ${bench_target})
  halfspace_bench(ztest_merge ${config} ${lanes})
  halfspace_script_test(static_cosim_${name} static_cosim_test.py WORLD cosim UNITS pipeline ztest_merge
    BUILDS halfspace ${pipeline_target} ${bench_target}
    COMMAND $<TARGET_FILE:halfspace> ${pipeline} ${bench} ${CMAKE_CURRENT_BINARY_DIR}/static_cosim_${name}
      ${config_of_${config}} ${lanes}
            ${ARGN})
endfunction()
halfspace_static_cosim(one objects_low 4 --stall 30 -- --frames 2000)
halfspace_static_cosim(three objects_low 4 --stall 0 --seed 2 -- --frames 1000 --buffers 3 --objects 14)
halfspace_static_cosim(box objects_low 4 --stall 20 --seed 3 -- --frames 500 --buffers 3 --no-query --size 37x23
                       --window 5)
halfspace_static_cosim(passes objects_tiny 1 --stall 20 --seed 4 -- --frames 600 --objects 16)
halfspace_static_cosim(reuse objects_tiny 1 --stall 10 --seed 5 -- --frames 600 --objects 16 --buffers 2 --window 3)
halfspace_static_cosim(lit objects_lit 4 --stall 20 --seed 6 -- --frames 400)
