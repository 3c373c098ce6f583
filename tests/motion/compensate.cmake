# motion_compensate: its bench with each filter, without stalls to the cycle, and
# faults in it.
set(configs motion_low motion_middle motion_high motion_area motion_cubic motion_tiny)
foreach(config IN LISTS configs)
  halfspace_cosim_file(motion_compensate ${config} 4 compensation)
  halfspace_cosim(motion_compensate_cycles_${config} motion_compensate ${config} 4 compensation STALL 0)
endforeach()
halfspace_lint(lint_compensate UNITS motion_compensate CONFIGS ${configs})
halfspace_faults(faults_compensate compensate motion_high SCENE compensation UNITS motion_compensate)

# Multipliers: of each key and channel 3 for two by two pixels and 15 for four by four, and one of each channel's blend.
# Memories: of each key a bank for each pixel of a block.
function(halfspace_compensate_left config multipliers memories)
  halfspace_synthesis(synthesis_compensate_${config} motion_compensate ${config} 4
                      FINDS "-assert-count ${multipliers} t:$mul" "-assert-count ${memories} t:$mem_v2")
endfunction()
halfspace_compensate_left(motion_low 3 8)
halfspace_compensate_left(motion_middle 21 8)
halfspace_compensate_left(motion_high 93 32)
