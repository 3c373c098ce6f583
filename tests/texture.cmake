# Texture: the tops in configurations with each filter and each mapping.
foreach(config IN ITEMS TexturedLow TexturedMiddle TexturedFlat TexturedPhong)
  halfspace_tops_test(texture_tops_test_${config} texture_tops_test.cpp ${config} textured_configs.hpp
                      ${PROJECT_SOURCE_DIR}/hls/top/texture_setup_top.cpp ${PROJECT_SOURCE_DIR}/hls/top/shade_texture_top.cpp)
endforeach()
