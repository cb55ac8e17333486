# pupflow_target(NAME): the language level, warnings and floating-point rules that all code shares.
include(GNUInstallDirs)
include(CheckPIESupported)
check_pie_supported()

function(pupflow_target target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES
    CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON INTERPROCEDURAL_OPTIMIZATION ${PUPFLOW_IPO})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
  # One seed gives the same bits from every compiler and at every level: no contraction of a * b + c.
  # -Wrestrict: GCC 12 warns wrongly about std::string (its bug 105651).
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> -ffp-contract=off -Wall -Wextra -Wshadow -Wconversion
    -Wno-sign-conversion -Wnon-virtual-dtor -Wold-style-cast $<$<BOOL:${PUPFLOW_WERROR}>:-Werror>)
  if(PUPFLOW_HARDEN)
    target_compile_options(${target} PRIVATE -fstack-protector-strong
      $<$<NOT:$<CONFIG:Debug>>:-U_FORTIFY_SOURCE> $<$<NOT:$<CONFIG:Debug>>:-D_FORTIFY_SOURCE=2>)
  endif()
  # The engine's symbols are visible for the shared library alone: what holds a copy keeps it to itself.
  target_link_options(${target} PRIVATE $<$<PLATFORM_ID:Linux>:-Wl,--exclude-libs,libpupflow.a>)
  # Linkage tables are filled at the start and read-only from then on.
  target_link_options(${target} PRIVATE $<$<PLATFORM_ID:Linux>:-Wl,-z,relro,-z,now>)
endfunction()

# pupflow_alone(FILE...): compiles each of these by itself where several files are compiled as one (presets
# check and engine, for the compiler's time): a local name of theirs is one of another file too.
function(pupflow_alone)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
