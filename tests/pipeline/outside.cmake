# The pipeline with memory outside: the same words, whatever the memory's seed. With the seed it is as slow, as early
# and as disordered as the contract of rtl/memory/hs_memory_pkg.sv allows. Stalls: without any, cycles would be held to
# those of memory inside.
set(outside OutsideFrame=1 OutsidePlanes=1)
halfspace_cosim(outside_standard_low_1 pipeline low 1 standard STALL 10 SEEDS 3 PARAMETERS ${outside})
halfspace_cosim(outside_standard_low_16 pipeline low 16 standard STALL 10 SEEDS 10 PARAMETERS ${outside} MemoryBits=128)
halfspace_cosim(outside_standard_middle_4 pipeline middle 4 standard SEEDS 10
                PARAMETERS ${outside} CacheTilesX=4 CacheTilesY=2)
halfspace_cosim(outside_teapot_middle_4 pipeline middle 4 teapot STALL 5 SEEDS 2 VECTORS --no-corners
                PARAMETERS ${outside})
halfspace_cosim(outside_castle_high_4 pipeline high 4 castle STALL 5 VECTORS --no-corners --size 320x240
                PARAMETERS ${outside} CacheTilesX=8 CacheTilesY=8)
# What Yosys makes of it.
halfspace_cosim(outside_netlist_low_4 pipeline low 4 standard NETLIST PARAMETERS ${outside})
halfspace_faults(outside_faults outside low SCENE castle PARAMETERS ${outside} CacheTilesX=4 CacheTilesY=4
                 UNITS pipeline)
