# Lists the cases of a Catch2 program for ctest, one test each. Run after the program is linked, with
# PROGRAM, FOLDER (its label, and the prefix of its tests), CASES (the file to write) and CATCH (the
# version). Not Catch2's own module: that of Catch2 2 cuts a name at each semicolon, and a program
# that is asked for half a name runs nothing and succeeds.

if(CATCH VERSION_LESS 3)
  set(list --list-test-names-only)
  set(options -w NoTests) # a name that matches no case is a failure; Catch2 3 does so by itself
else()
  set(list --list-tests --verbosity quiet)
  set(options)
endif()
# Catch2 2 returns the number of cases, so that only what it prints tells success.
execute_process(COMMAND ${PROGRAM} ${list} OUTPUT_VARIABLE names ERROR_VARIABLE complaint)
if(names STREQUAL "" OR NOT complaint STREQUAL "")
  message(FATAL_ERROR "${PROGRAM} lists no cases: ${complaint}")
endif()

set(script "")
while(NOT names STREQUAL "") # not a CMake list, which brackets and semicolons would break
  string(FIND "${names}" "\n" end)
  string(SUBSTRING "${names}" 0 ${end} name)
  math(EXPR next "${end} + 1")
  string(SUBSTRING "${names}" ${next} -1 names)
  if(name STREQUAL "")
    continue()
  endif()
  string(REGEX REPLACE "([][\\,\"~-])" "\\\\\\1" pattern "${name}")
  string(APPEND script "add_test([==[${FOLDER}: ${name}]==] [==[${PROGRAM}]==] [==[${pattern}]==] ${options})\n"
    "set_tests_properties([==[${FOLDER}: ${name}]==] PROPERTIES LABELS ${FOLDER})\n")
endwhile()
file(WRITE ${CASES} "${script}")
