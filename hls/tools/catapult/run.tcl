# SPDX-License-Identifier: Apache-2.0
# Catapult on a top, as the makefile beside it calls this: it sets all that is read of the environment. A channel is a
# wire with valid and ready, an array outside a memory. The simulation by SCVerify wants macros of its own in a bench,
# so that the C++ is to be run before, as docs/port.md tells.
set design $env(TOP)_top
switch $env(DEVICE) {
  zynq       { set library {mgc_Xilinx-ZYNQ-1_beh -- -rtlsyntool Vivado -manufacturer Xilinx -family ZYNQ -speed -1 \
                            -part xc7z020clg484-1} }
  zynq-uplus { set library {mgc_Xilinx-ZYNQ-uplus-2_beh -- -rtlsyntool Vivado -manufacturer Xilinx \
                            -family ZYNQ-uplus -speed -2 -part xczu7ev-ffvc1156-2-e} }
  default    { error "$env(DEVICE): the devices are zynq and zynq-uplus" }
}

solution new -state initial
solution options defaults
solution options set /Input/CppStandard c++14
solution options set /Input/SearchPath $env(FOLDERS)
solution options set /Input/CompilerFlags $env(FLAGS)
solution file add $env(FILE) -type C++

go analyze
directive set -DESIGN_HIERARCHY [concat $design $env(BLOCKS)]
go compile

solution library add {*}$library
solution library add Xilinx_RAMS
solution library add Xilinx_ROMS
solution library add Xilinx_FIFO
go libraries
directive set -CLOCKS [list clk [list -CLOCK_PERIOD $env(PERIOD)]]
go assembly

# Of a label that comes more than once, the tool numbers the loops: Lanes, Lanes#1, …
foreach loop $env(LOOPS) {
  lassign [split $loop =] label directive
  set option [expr {$directive eq "unroll" ? "UNROLL" : "PIPELINE_INIT_INTERVAL"}]
  set value [expr {$directive eq "unroll" ? "yes" : $directive}]
  foreach end {{} {#*}} {
    foreach path [directive get -match glob -checkpath 0 -ret p /$design/*/$label$end/$option] {
      directive set $path $value
    }
  }
}
go architect
go extract
project save
exit
