# hs_static_frames, and static_run in it: whole sequences, passes and commands, the buffers in a memory of the bench.
function(halfspace_static_frames name config lanes)
  cmake_parse_arguments(PARSE_ARGV 3 S "LONG" "STALL" "OPTIONS;VECTORS")
  if(NOT DEFINED S_STALL)
    set(S_STALL 30)
  endif()
  set(long "")
  if(S_LONG)
    set(long LONG)
  endif()
  halfspace_cosim(static_frames_${name} static_frames ${config} ${lanes} static_frames ${long} STALL ${S_STALL}
                  OPTIONS ${S_OPTIONS} VECTORS ${S_VECTORS})
endfunction()
halfspace_static_frames(three objects_low 4 VECTORS --frames 60 --objects 14)
halfspace_static_frames(passes objects_tiny 1 STALL 20 VECTORS --frames 60 --objects 16 --seed 2)
halfspace_static_frames(lit objects_lit 4 VECTORS --frames 25 --seed 3 --buffers 2)
# Without stalls: cycles of the sequence beside what its busiest unit takes.
halfspace_static_frames(cycles objects_low 4 STALL 0 OPTIONS --bound 1.5 VECTORS --frames 40 --size 160x120)
# 1,000 frames each: with one S-buffer and seven, query and none, several passes, and index reuse.
halfspace_static_frames(1000_seven objects_low 4 LONG VECTORS --frames 1000 --objects 14 --buffers 7 --seed 11)
halfspace_static_frames(1000_passes objects_tiny 1 LONG STALL 10
                        VECTORS --frames 1000 --objects 16 --buffers 2 --window 3 --no-query --seed 12)

halfspace_cosim(static_run_objects_low_4 static_run objects_low 4 static_frames SEEDS 3 VECTORS --objects 14)
halfspace_cosim(static_run_objects_middle_16 static_run objects_middle 16 static_frames
                VECTORS --objects 14 --size 61x37)
halfspace_cosim(static_run_objects_tiny_1 static_run objects_tiny 1 static_frames VECTORS --objects 16)
halfspace_lint(lint_static UNITS static_run static_frames CONFIGS objects_low objects_flat objects_phong)
halfspace_faults(faults_static static objects_low SCENE static_frames UNITS static_run)
halfspace_faults(faults_static_frames static_frames objects_low SCENE static_frames UNITS static_frames)
halfspace_synthesis(synthesis_static_run static_run objects_low 4
                    FINDS "-assert-none t:$mul t:$mem_v2" "-assert-min 1 t:$eq")
