# Films: hs_up_convert and its units against the kernels, and the units on random words. Scene `film` is a short
# animation whose frames in between have holes.
set(film_units pixel_store motion_order hole_find hole_scan film_scan)
halfspace_units_film(film_tiny 1 ${film_units} motion_compensate motion_field)
halfspace_units_film(film_textured 16 pixel_store hole_scan film_scan)
halfspace_cosim(up_convert_film_tiny_1 up_convert film_tiny 1 film SEEDS 3)
halfspace_cosim(up_convert_film_middle_4 up_convert film_middle 4 film)
# Flat, and relit.
halfspace_cosim(up_convert_film_flat_8 up_convert film_flat 8 film)
halfspace_cosim(netlist_film_tiny_4 up_convert film_tiny 4 film NETLIST)
halfspace_lint(lint_film UNITS ${film_units} CONFIGS film_tiny film_phong)
halfspace_faults(faults_film film film_tiny WORDS film_words.py UNITS ${film_units})

# With label `long` the ten animations, with one frame between key frames and with four; and faults in what puts the
# units together.
set(films "")
foreach(film IN ITEMS phong textured middle)
  list(APPEND films ${film}-1-4 ${film}-4-4)
endforeach()
halfspace_matrix(film_matrix_long film_matrix_test.py UNITS up_convert LONG CASES ${films})
halfspace_faults(faults_film_top film_top film_middle SCENE cube_fast LONG UNITS up_convert)
