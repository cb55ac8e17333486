# Debian packages: `cpack` in the build folder makes one a component. packaging/debian/finish.cmake adds
# what Debian wants of a package beside the installed files.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR pupflow)
# There is no public address yet, and `invalid` is the domain that says so.
set(CPACK_PACKAGE_CONTACT "The pupflow developers <maintainers@pupflow.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
  GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/packaging/debian/finish.cmake)
set(CPACK_PUPFLOW_SOURCE ${PROJECT_SOURCE_DIR})
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_COMPONENTS_ALL "")
set(control ${CMAKE_CURRENT_BINARY_DIR}/debian)

# package(COMPONENT NAME SECTION DEPENDS CONTAINS SYNOPSIS WORDS): DEPENDS beside the libraries that are
# linked. CONTAINS are Debian packages whose code is compiled in, and whose licences it therefore carries.
macro(package component name section depends contains synopsis words)
  string(TOUPPER ${component} key)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${key}_PACKAGE_SECTION ${section})
  set(CPACK_DEBIAN_${key}_PACKAGE_DEPENDS "${depends}")
  set(CPACK_PUPFLOW_${key}_CONTAINS ${contains})
  set(CPACK_COMPONENT_${key}_DESCRIPTION "${synopsis}
pupflow simulates S. P. Wilson's model of thermoregulatory huddling: soft,
warm bodies that huddle by themselves when it is cold and part when it is
warm.\n\n${words}")
endmacro()

set(same "(= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")
set(of_program "libcli11-dev;libeigen3-dev;libtomlplusplus-dev;fonts-dejavu-core")
package(program pupflow science "" "${of_program}"
  "simulation of thermoregulatory huddling" "This package has the command line, which needs no graphics.")
package(graphics pupflow-graphics science "pupflow ${same}, libgl1-mesa-dri | libgl1"
  "${of_program};libimgui-dev;libstb-dev" "pictures and live window of pupflow"
  "This package has the pictures, which need no display, and the live window.")
package(doc pupflow-doc doc "" "" "documentation of pupflow" "This package has its pages, pictures, reports and examples.")
set(CPACK_DEBIAN_DOC_PACKAGE_ARCHITECTURE all)
package(engine libpupflow-dev libdevel "libeigen3-dev" "libeigen3-dev" "library of pupflow for C++ programs"
  "This package has headers, the static library, a CMake package and a\npkg-config file.")
if(TARGET pupflow_engine_shared)
  set(abi ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  set(library libpupflow${abi})
  string(APPEND CPACK_DEBIAN_ENGINE_PACKAGE_DEPENDS ", ${library} ${same}")
  package(library ${library} libs "" "libeigen3-dev" "shared library of pupflow"
    "This package has the library that C++ programs load.")
  file(CONFIGURE OUTPUT ${control}/shlibs CONTENT "libpupflow ${abi} ${library} (>= ${PROJECT_VERSION})\n")
  file(CONFIGURE OUTPUT ${control}/triggers CONTENT "activate-noawait ldconfig\n")
  set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${control}/shlibs ${control}/triggers)
endif()
if(TARGET pupflow_mpi)
  package(mpi pupflow-mpi science "pupflow ${same}" "${of_program}" "sweeps of pupflow on many machines"
    "This package lets the ranks of an MPI job share a sweep.")
  set(CPACK_DEBIAN_MPI_PACKAGE_RECOMMENDS mpi-default-bin)
endif()
if(TARGET pupflow_python)
  execute_process(COMMAND ${PUPFLOW_PYTHON_EXECUTABLE} -c
    "import sys; a, b = sys.version_info[:2]; print(f'python3 (>= {a}.{b}~), python3 (<< {a}.{b + 1})')"
    OUTPUT_VARIABLE python OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  package(python python3-pupflow python "${python}, python3-numpy" "${of_program};pybind11-dev"
    "pupflow for Python" "This package has the module pupflow: litters to step, edit, observe and draw.")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    ${PROJECT_SOURCE_DIR}/packaging/debian/python/postinst ${PROJECT_SOURCE_DIR}/packaging/debian/python/prerm)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS pupflow-graphics)
endif()
# Those of two architectures can be installed side by side; of the pages one serves all. CPack before CMake
# 3.31 has no word for this field: it goes with the section, as a line of its own.
foreach(key LIBRARY ENGINE)
  string(APPEND CPACK_DEBIAN_${key}_PACKAGE_SECTION "\nMulti-Arch: same")
endforeach()
string(APPEND CPACK_DEBIAN_DOC_PACKAGE_SECTION "\nMulti-Arch: foreign")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS
  "pupflow-graphics, pupflow-mpi, pupflow-doc, python3-pupflow, gnuplot-nox, ffmpeg")
set(CPACK_DEBIAN_ENGINE_PACKAGE_SUGGESTS pupflow-doc)
include(CPack)
