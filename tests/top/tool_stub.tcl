# SPDX-License-Identifier: Apache-2.0
# Stands in for a tool that runs a script by -f: its commands print themselves and their arguments as a Tcl list, with
# "call" before it. A command that the tool has not is an error. Usage: tclsh tool_stub.tcl VITIS|CATAPULT … -f SCRIPT
set commands(vitis) {open_project set_top add_files open_solution set_part create_clock csim_design csynth_design
                     cosim_design export_design}
set commands(catapult) {solution go directive project}
foreach command $commands([lindex $argv 0]) {
  proc $command {args} {
    puts [concat call [list [lindex [info level 0] 0]] $args]
    # Two loops of each label that is asked for.
    if {[lrange $args 0 1] eq {get -match}} {
      return [list [string map {/*/ /core/ #* #1} [lindex $args end]]]
    }
  }
}
source [lindex $argv end]
