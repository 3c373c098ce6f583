# The whole pipeline in sizes, architectures, shadings and textures; all of them with label `long`.
function(halfspace_matrix name lanes seeds)
  add_test(NAME ${name} COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/pipeline/matrix_test.py $<TARGET_FILE:halfspace>
    ${CMAKE_CURRENT_BINARY_DIR}/${name} ${ARGN} --lanes ${lanes} --textured-scene ${HALFSPACE_TESTMODELS}/Collada/duck.dae --seeds ${seeds} --jobs 2
    --library $<TARGET_FILE:halfspace_tb> --library $<TARGET_FILE:halfspace_verilated> --verilator ${HALFSPACE_VERILATOR} --cxx ${CMAKE_CXX_COMPILER})
  set_tests_properties(${name} PROPERTIES PROCESSORS 2 TIMEOUT 7200)
endfunction()
halfspace_matrix(matrix 4 2 low-gamma-phong middle-delta-phong high-delta-gouraud low-gamma-flat-nearest-affine
  middle-delta-gouraud-bilinear-perspective high-delta-phong-bilinear-perspective)
halfspace_matrix(matrix_1 1 2 low-delta-gouraud-nearest-perspective)
halfspace_matrix(matrix_16 16 2 middle-gamma-phong-bilinear-affine)
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
halfspace_matrix(matrix_long 4 10 ${all})
set_tests_properties(matrix_long PROPERTIES LABELS long)

# A frame of 3104 triangles with 2500 indices.
halfspace_cosim_file(reuse 4 pipeline)
add_test(NAME pipeline_reuse_castle COMMAND Python3::Interpreter ${cosim_tool} $<TARGET_FILE:halfspace>
         ${CMAKE_CURRENT_BINARY_DIR}/model_pipeline_reuse_4/bench ${CMAKE_CURRENT_BINARY_DIR}/pipeline_reuse_castle castle
         ${config_of_reuse} 4 --stall 30 --seeds 3 -- --window 64 --random 1)
