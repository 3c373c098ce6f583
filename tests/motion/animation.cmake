# Frames between key frames of ten built-in animations: in every run two of the benches, with label `long` each filter in each size with one
# and with 4x4 samples, and the motion field in each size.
function(halfspace_animation_matrix name)
  add_test(NAME ${name} COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/motion/animation_matrix_test.py $<TARGET_FILE:halfspace>
    ${CMAKE_CURRENT_BINARY_DIR}/${name} ${ARGN} --jobs 2 --library $<TARGET_FILE:halfspace_tb> --library $<TARGET_FILE:halfspace_verilated>
    --verilator ${HALFSPACE_VERILATOR} --cxx ${CMAKE_CXX_COMPILER})
  set_tests_properties(${name} PROPERTIES PROCESSORS 2 TIMEOUT 7200)
endfunction()
halfspace_animation_matrix(animation_matrix middle-bilinear-1 middle-field-4)
set(all "")
foreach(size IN ITEMS low middle high)
  foreach(filter IN ITEMS nearest bilinear area bicubic)
    list(APPEND all ${size}-${filter}-1 ${size}-${filter}-4)
  endforeach()
  list(APPEND all ${size}-field-1 ${size}-field-4 ${size}-field-16)
endforeach()
halfspace_animation_matrix(animation_matrix_long ${all})
set_tests_properties(animation_matrix_long PROPERTIES LABELS long)
