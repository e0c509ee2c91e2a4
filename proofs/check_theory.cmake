# SPDX-License-Identifier: GPL-3.0-or-later
cmake_minimum_required(VERSION 3.25)
# cmake -DCOQC= -DSOURCE= -DBINARY= -DNAME= -P check_theory.cmake: has coqc check one file. Sources are copied, so that
# compiled files stay out of the source tree.
file(MAKE_DIRECTORY ${BINARY})
file(COPY ${SOURCE}/${NAME}.v DESTINATION ${BINARY})
execute_process(COMMAND ${COQC} -q -Q . Gnomon ${NAME}.v WORKING_DIRECTORY ${BINARY} RESULT_VARIABLE status)
if(status)
  message(FATAL_ERROR "coqc does not accept ${NAME}.v")
endif()
