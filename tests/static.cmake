# The static objects buffer by the kernels.
halfspace_test(merge_test)
halfspace_test(static_kernel_test)
target_compile_definitions(static_kernel_test PRIVATE HALFSPACE_SOURCE="${PROJECT_SOURCE_DIR}")
foreach(config IN ITEMS ObjectsLow ObjectsMiddle ObjectsHigh)
  halfspace_tops_test(merge_tops_test_${config} merge_tops_test.cpp ${config} object_configs.hpp
                      ${PROJECT_SOURCE_DIR}/hls/top/ztest_merge_top.cpp ${PROJECT_SOURCE_DIR}/hls/top/scan_object_top.cpp)
endforeach()
