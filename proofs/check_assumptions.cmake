# SPDX-License-Identifier: GPL-3.0-or-later
cmake_minimum_required(VERSION 3.25)
# cmake -DCOQC= -DSOURCE= -DBINARY= -P check_assumptions.cmake: fails when one of our files leaves a proof out or
# postulates something, and when a theorem listed in main_theorems.txt rests on anything but the axioms below.
set(allowed
    # how Coq's standard library makes the real numbers
    ClassicalDedekindReals.sig_forall_dec ClassicalDedekindReals.sig_not_dec
    FunctionalExtensionality.functional_extensionality_dep
    # excluded middle, which Flocq uses
    Classical_Prop.classic)

set(failed FALSE)
file(GLOB theories ${SOURCE}/*.v)
foreach(file IN LISTS theories)
  file(READ ${file} text)
  string(REGEX MATCHALL
         "(Admitted|admit|give_up|Axioms?|Parameters?|Conjecture|Unset Guard Checking|bypass_check)[^A-Za-z0-9_]" found
         "${text}")
  if(found)
    message(SEND_ERROR "${file}: ${found}")
    set(failed TRUE)
  endif()
endforeach()

set(script "")
foreach(file IN LISTS theories)
  get_filename_component(name ${file} NAME_WE)
  string(APPEND script "Require Gnomon.${name}.\n")
endforeach()
file(STRINGS ${SOURCE}/main_theorems.txt theorems REGEX "^[A-Z]")
# One question about all of them together: each alone would make Coq walk through the real numbers again.
list(TRANSFORM theorems PREPEND "@Gnomon." OUTPUT_VARIABLE terms)
list(JOIN terms ", " terms)
string(APPEND script "Definition every_theorem := (${terms}).\nPrint Assumptions every_theorem.\n")
set(directory ${BINARY}/assumptions)
file(MAKE_DIRECTORY ${directory})
file(WRITE ${directory}/print_assumptions.v "${script}")
execute_process(COMMAND ${COQC} -q -Q ${BINARY} Gnomon print_assumptions.v WORKING_DIRECTORY ${directory}
                RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE errors)
if(status)
  message(FATAL_ERROR "${output}${errors}")
endif()
list(LENGTH theorems expected)
if(NOT output MATCHES "^Axioms:" OR expected EQUAL 0)
  message(SEND_ERROR "${expected} theorems, and Coq says:\n${output}")
  set(failed TRUE)
endif()
# An axiom's name begins its line.
string(REGEX MATCHALL "\n[A-Za-z_][A-Za-z0-9_.']*" names "\n${output}")
list(REMOVE_DUPLICATES names)
foreach(name IN LISTS names)
  string(STRIP "${name}" name)
  if(NOT name STREQUAL "Axioms" AND NOT name IN_LIST allowed)
    message(SEND_ERROR "A main theorem assumes ${name}")
    set(failed TRUE)
  endif()
endforeach()
if(NOT failed)
  message(STATUS "${expected} theorems rest on the standard real numbers alone")
endif()
