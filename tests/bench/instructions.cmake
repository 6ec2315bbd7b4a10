# Counts the instructions of a rendering at 1 and at 81 bands, where nothing disperses, and fails
# when the second are more than twice the first: bundles have fallen apart, or the work per band has
# grown. Instructions do not depend on the machine's mood. Called with VALGRIND, ABBE and SCENE.

function(count_instructions bands count)
  execute_process(
    COMMAND ${VALGRIND} --tool=callgrind --callgrind-out-file=/dev/null "--toggle-collect=abbe::render(*SampleRange*"
            ${ABBE} render ${SCENE} --size 24x24 --spp 1 --threads 1 --bands ${bands} -o instructions.exr
    OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE code)
  if(NOT code EQUAL 0 OR NOT said MATCHES "Collected : ([0-9]+)")
    message(FATAL_ERROR "valgrind failed:\n${said}")
  endif()
  set(${count} ${CMAKE_MATCH_1} PARENT_SCOPE)
endfunction()

count_instructions(1 one)
count_instructions(81 all)
math(EXPR percent "100 * ${all} / ${one}")
message("instructions: ${one} at 1 band, ${all} at 81, ${percent} %")
if(one LESS 1000000)
  message(FATAL_ERROR "too few to be a rendering: is abbe::render still what it is called?")
endif()
if(percent GREATER 200)
  message(FATAL_ERROR "more than twice as many")
endif()
