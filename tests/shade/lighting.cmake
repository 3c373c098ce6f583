# Configurations with lighting (lit_configs.hpp, configs/lit): the tops, units and pipeline of the RTL against
# the kernels on corner cases, random triangles and normals and on scenes, lint, and what Yosys finds.
foreach(config IN ITEMS LitHigh LitMatte)
  halfspace_tops_test(light_tops_test_${config} light_tops_test.cpp ${config} shade/lit_configs.hpp
                      UNITS light_vertex visible_select shade_setup TOPS light_vertex visible_select shade_setup_lit)
endforeach()
set(configs lit_low lit_middle lit_high lit_matte)
foreach(config IN LISTS configs)
  halfspace_cosim_file(light_units ${config} 4)
endforeach()
halfspace_lint(lint_lighting UNITS light_vertex visible_select shade_setup CONFIGS ${configs})
halfspace_faults(faults_lighting lighting light_units lit_high UNITS light_vertex visible_select shade_setup triangle_setup)

# The normals of scenes.
function(halfspace_lit_scene config scene)
  halfspace_cosim(light_units_${config}_${scene} light_units ${config} 4 ${scene} SEEDS 2 VECTORS --no-corners --size 64x48)
endfunction()
halfspace_lit_scene(lit_low teapot)
halfspace_lit_scene(lit_middle wheel)
halfspace_lit_scene(lit_high castle)
halfspace_lit_scene(lit_high polyhedron)

# The netlist that Yosys makes of the unit.
halfspace_cosim(light_netlist_lit_high light_units lit_high 4 standard NETLIST)

# Multipliers: three a dot product, of which there are |n|² and one or two a light; the root's; a cosine's and a channel's for
# diffuse light and for highlights; the squarings. Memories: the materials, and their exponents.
function(halfspace_lighting_left config vertices multipliers memories)
  halfspace_synthesis(synthesis_${config} light_vertex ${config} UNITS light_vertex PARAMETERS Vertices ${vertices}
                      FINDS "-assert-count ${multipliers} t:$mul" "-assert-count ${memories} t:$mem_v2")
endfunction()
halfspace_lighting_left(lit_low 3 22 2)
halfspace_lighting_left(lit_middle 3 21 2)
halfspace_lighting_left(lit_high 3 22 2)
halfspace_lighting_left(lit_matte 1 11 1)
