# The static objects buffer by the kernels.
halfspace_test(merge_test)
halfspace_test(static_kernel_test)
target_compile_definitions(static_kernel_test PRIVATE HALFSPACE_SOURCE="${PROJECT_SOURCE_DIR}")
