# The whole pipeline in sizes, architectures, shadings and textures; all of them with label `long`.
set(scene --textured-scene ${HALFSPACE_TESTMODELS}/Collada/duck.dae)
halfspace_matrix(matrix matrix_test.py UNITS pipeline OPTIONS ${scene} --lanes 4 --seeds 2
  CASES low-gamma-phong middle-delta-phong high-delta-gouraud low-gamma-flat-nearest-affine
        middle-delta-gouraud-bilinear-perspective high-delta-phong-bilinear-perspective)
halfspace_matrix(matrix_1 matrix_test.py UNITS pipeline OPTIONS ${scene} --lanes 1 --seeds 2
                 CASES low-delta-gouraud-nearest-perspective)
halfspace_matrix(matrix_16 matrix_test.py UNITS pipeline OPTIONS ${scene} --lanes 16 --seeds 2
                 CASES middle-gamma-phong-bilinear-affine)
set(all "")
foreach(size IN ITEMS low middle high)
  foreach(architecture IN ITEMS delta gamma)
    foreach(shading IN ITEMS flat gouraud phong)
      list(APPEND all ${size}-${architecture}-${shading})
      if(architecture STREQUAL "delta")
        list(APPEND all ${size}-delta-${shading}-objects ${size}-delta-${shading}-bilinear-perspective-objects)
      endif()
      foreach(texture IN ITEMS nearest-affine nearest-perspective bilinear-affine bilinear-perspective)
        list(APPEND all ${size}-${architecture}-${shading}-${texture})
      endforeach()
    endforeach()
  endforeach()
endforeach()
halfspace_matrix(matrix_long matrix_test.py UNITS pipeline LONG OPTIONS ${scene} --lanes 4 --seeds 10 CASES ${all})

# Several units of setup in turn, and background past the shader; with label `long` each interval.
halfspace_matrix(setup_cycles setup_cycles_test.py UNITS pipeline OPTIONS --seeds 2
                 CASES odd-8-4 lit_low-4-4 flat_only-2-2)
halfspace_matrix(setup_cycles_long setup_cycles_test.py UNITS pipeline LONG OPTIONS --seeds 5
                 CASES odd-1-16 odd-2-4 odd-4-1 odd-16-2 lit_low-8-4 gamma_odd-16-4 gamma_tiny-2-1 tiny-1-1 tiny-4-8)
