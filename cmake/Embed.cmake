# pupflow_embed(TARGET FILE SYMBOL): puts the bytes of FILE into TARGET, between the symbols SYMBOL_begin and
# SYMBOL_end. The assembler includes the file itself, so that big ones cost no compile time.
function(pupflow_embed target file symbol)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/embedded_${symbol}.cpp)
  file(CONFIGURE OUTPUT ${source} @ONLY CONTENT [[
asm(R"(
    .pushsection .rodata
    .balign 16
    .global @symbol@_begin
    .hidden @symbol@_begin
@symbol@_begin:
    .incbin "@file@"
    .global @symbol@_end
    .hidden @symbol@_end
@symbol@_end:
    .byte 0
    .popsection
)");
]])
  # In a unity build the dependency would be lost.
  set_source_files_properties(${source} PROPERTIES OBJECT_DEPENDS ${file} SKIP_UNITY_BUILD_INCLUSION ON)
  target_sources(${target} PRIVATE ${source})
endfunction()
