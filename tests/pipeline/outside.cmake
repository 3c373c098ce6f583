# The pipeline with memory outside: the same words, whatever the memory's seed. With the seed it is as slow, as early
# and as disordered as the contract of rtl/memory/hs_memory_pkg.sv allows.
foreach(lanes IN ITEMS 1 16)
  halfspace_cosim(outside_standard_low_${lanes} pipeline low ${lanes} standard STALL 10 SEEDS 10
                  PARAMETERS OutsideFrame=1 OutsidePlanes=1)
endforeach()
halfspace_cosim(outside_standard_middle_4 pipeline middle 4 standard SEEDS 10
                PARAMETERS OutsideFrame=1 OutsidePlanes=1 CacheTilesX=4 CacheTilesY=2)
halfspace_cosim(outside_teapot_middle_4 pipeline middle 4 teapot STALL 0 SEEDS 2 VECTORS --no-corners
                PARAMETERS OutsideFrame=1 OutsidePlanes=1)
halfspace_cosim(outside_castle_high_2 pipeline high 2 castle STALL 0 VECTORS --no-corners --size 640x480
                PARAMETERS OutsideFrame=1 OutsidePlanes=1 MemoryBits=128)
# What Yosys makes of it.
halfspace_cosim(outside_netlist_low_4 pipeline low 4 standard NETLIST
                PARAMETERS OutsideFrame=1 OutsidePlanes=1)
halfspace_faults(outside_faults outside low SCENE castle
                 PARAMETERS OutsideFrame=1 OutsidePlanes=1 CacheTilesX=4 CacheTilesY=4 UNITS pipeline)
