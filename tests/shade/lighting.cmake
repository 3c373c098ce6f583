# Configurations with lighting (lit_configs.hpp, configs/lit): units and pipeline of the RTL against
# the kernels on corner cases, random triangles and normals and on scenes, lint, and what Yosys finds.
set(configs lit_low lit_middle lit_high lit_matte)
foreach(config IN LISTS configs)
  halfspace_units_file(${config} 4 triangle_setup visible_select light_vertex shade_setup)
endforeach()
halfspace_lint(lint_lighting UNITS light_vertex visible_select shade_setup CONFIGS ${configs})
halfspace_faults(faults_lighting lighting lit_high UNITS triangle_setup visible_select light_vertex shade_setup)
halfspace_cosim(light_vertex_extremes_lit_low light_vertex lit_low 4 extremes)
halfspace_faults(faults_one_unit one_unit lit_low SCENE extremes UNITS light_vertex)

# The normals of scenes.
function(halfspace_lit_scene config scene)
  foreach(unit triangle_setup visible_select light_vertex shade_setup)
    halfspace_cosim(${unit}_${config}_${scene} ${unit} ${config} 4 ${scene} SEEDS 2 VECTORS --no-corners --size 64x48)
  endforeach()
endfunction()
halfspace_lit_scene(lit_low teapot)
halfspace_lit_scene(lit_middle wheel)
halfspace_lit_scene(lit_high castle)
halfspace_lit_scene(lit_high polyhedron)

# The netlists that Yosys makes of the units.
foreach(unit triangle_setup visible_select light_vertex shade_setup)
  halfspace_cosim(${unit}_netlist_lit_high ${unit} lit_high 4 standard NETLIST)
endforeach()

# Multipliers: three a dot product, of which there are |n|² and one or two a light; the root's; a cosine's and a
# channel's for diffuse light and for highlights; the squarings. Memories: the materials, and their exponents.
function(halfspace_lighting_left config multipliers memories)
  halfspace_synthesis(synthesis_${config} light_vertex ${config} 4
                      FINDS "-assert-count ${multipliers} t:$mul" "-assert-count ${memories} t:$mem_v2")
endfunction()
halfspace_lighting_left(lit_low 22 2)
halfspace_lighting_left(lit_middle 21 2)
halfspace_lighting_left(lit_high 22 2)
halfspace_lighting_left(lit_matte 11 1)
