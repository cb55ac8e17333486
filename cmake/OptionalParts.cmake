# What pupflow works without, a row each: name | what needs it | what that is | Debian's packages | kind |
# what is looked for. Of kind "built" it is a target here; the program then looks for the files behind it,
# from its own folder. Of kind "run" it is a program on the PATH. `pupflow doctor` reads the same table.
file(RELATIVE_PATH module_folder ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR}/pupflow)
set(PUPFLOW_OPTIONAL_PARTS
  "mpi|sweeps over several machines|MPI|libopenmpi-dev|built|pupflow_mpi:libpupflow_mpi.so:${module_folder}/libpupflow_mpi.so"
  "python|scripts in Python|pybind11|python3-dev python3-numpy pybind11-dev|built|pupflow_python:../python/pupflow/py.typed:../${PUPFLOW_PYTHON_FOLDER}/pupflow/py.typed"
  "figures|the figures of sweeps|gnuplot|gnuplot-nox|run|gnuplot"
  "films|films|ffmpeg|ffmpeg|run|ffmpeg")

# Says in one line what was found and what was not, and writes the table for the program.
function(pupflow_tell_optional_parts)
  set(found)
  set(absent)
  set(PUPFLOW_OPTIONAL_ROWS)
  foreach(row ${PUPFLOW_OPTIONAL_PARTS})
    string(REPLACE "|" ";" row "${row}")
    list(GET row 1 purpose)
    list(GET row 2 thing)
    list(GET row 3 packages)
    list(POP_BACK row places)
    string(REPLACE ":" ";" places "${places}")
    list(GET row 4 kind)
    if(kind STREQUAL "built")
      list(POP_FRONT places target)
      set(is_here ${target})
    else()
      find_program(is_here ${places} NO_CACHE NO_DEFAULT_PATH PATHS ENV PATH)
    endif()
    if((kind STREQUAL "built" AND TARGET ${is_here}) OR (kind STREQUAL "run" AND is_here))
      list(APPEND found ${thing})
    else()
      list(APPEND absent "${thing} (for ${purpose}: apt install ${packages})")
    endif()
    unset(is_here)
    list(TRANSFORM row REPLACE "(.+)" "\"\\1\", ")
    list(JOIN row "" row)
    list(JOIN places "\", \"" places)
    string(APPEND PUPFLOW_OPTIONAL_ROWS "    {${row}{\"${places}\"}},\n")
  endforeach()
  configure_file(${PROJECT_SOURCE_DIR}/app/cli/optional_parts.h.in
    ${PROJECT_BINARY_DIR}/app/cli/optional_parts.h @ONLY)
  list(JOIN found ", " found)
  list(JOIN absent ", " absent)
  set(words)
  if(found)
    string(APPEND words " Found: ${found}.")
  endif()
  if(absent)
    string(APPEND words " Goes without: ${absent}.")
  endif()
  message(NOTICE "pupflow ${PROJECT_VERSION}.${words}")
endfunction()
