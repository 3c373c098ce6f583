# SPDX-License-Identifier: Apache-2.0
# Vitis HLS on a top, as the makefile beside it calls this: it sets all that is read of the environment. Pragmas are in
# the sources.
open_project -reset $env(TOP)
set_top $env(TOP)_top
add_files $env(FILE) -cflags $env(FLAGS)
foreach file $env(BENCH) { add_files -tb $file -cflags $env(BENCH_FLAGS) }

open_solution -reset -flow_target vivado $env(PART)
set_part $env(PART)
create_clock -period $env(PERIOD) -name default

foreach step $env(STEPS) {
  switch $step {
    csim    { csim_design -argv $env(ARGUMENTS) }
    csynth  { csynth_design }
    cosim   { cosim_design -argv $env(ARGUMENTS) }
    export  { export_design -format ip_catalog }
    default { error "$step: the steps are csim, csynth, cosim and export" }
  }
}
exit
