# Proofs by Yosys and ABC, on the smallest configurations; each finds faults that are put in as well.
find_program(HALFSPACE_ABC NAMES berkeley-abc yosys-abc REQUIRED)
# halfspace_proof(NAME CONFIG UNITS unit … OPTIONS …): tb/proofs/prove.py.
function(halfspace_proof name config)
  cmake_parse_arguments(PARSE_ARGV 2 P "" "" "UNITS;OPTIONS")
  halfspace_package(${config})
  halfspace_add_test(NAME ${name} WORLD rtl UNITS ${P_UNITS} SECONDS 1200 BUILDS ${package_target}
    COMMAND $<TARGET_FILE:Python3::Interpreter> ${PROJECT_SOURCE_DIR}/tb/proofs/prove.py --yosys ${HALFSPACE_YOSYS}
      --abc ${HALFSPACE_ABC} --package ${package} --broken ${PROJECT_SOURCE_DIR}/tb/proofs/broken.txt --seconds 300
      ${P_OPTIONS})
endfunction()

# What is offered stays.
function(halfspace_offers_stay config)
  foreach(unit IN LISTS ARGN)
    halfspace_proof(proof_offers_${unit} ${config} UNITS ${unit} OPTIONS --units ${unit})
  endforeach()
endfunction()
halfspace_offers_stay(micro triangle_setup raster_pineda ztest_index scan_index shade_setup shade_gouraud)
halfspace_offers_stay(gamma_tiny ztest_plane)
halfspace_offers_stay(objects_tiny scan_object ztest_merge)
halfspace_offers_stay(lit_matte visible_select)
foreach(path IN ITEMS film motion objects phong pool textured)
  set(config_of_micro_${path} ${PROJECT_SOURCE_DIR}/tb/proofs/micro_${path}.toml)
endforeach()
halfspace_offers_stay(micro_pool index_pool)
halfspace_offers_stay(micro_objects static_run)
halfspace_offers_stay(micro_film motion_order hole_find hole_scan film_scan)
halfspace_offers_stay(micro_phong phong_setup)
halfspace_offers_stay(micro_textured texture_setup shade_texture)
halfspace_offers_stay(micro_motion motion_setup motion_field motion_compensate)
# Queues and forks; what the Z-test forwards.
foreach(harness IN ITEMS queue fork)
  halfspace_proof(proof_${harness} micro UNITS pipeline OPTIONS --harness ${PROJECT_SOURCE_DIR}/tb/proofs/${harness}.v)
endforeach()
halfspace_proof(proof_forward micro UNITS ztest_index OPTIONS --harness ${PROJECT_SOURCE_DIR}/tb/proofs/forward.v)
