# Writes a C++ table of files (file name → text): the function FUNCTION() of HEADER, which returns a vector of TYPE.
# Usage: cmake -DOUTPUT=… "-DFILES=…" -DHEADER=render/passes/shader_sources.h -DTYPE=ShaderSource -DFUNCTION=shader_sources -P embed_files.cmake
set(rows "")
foreach(file IN LISTS FILES)
    get_filename_component(name ${file} NAME)
    file(READ ${file} text)
    if(WITHOUT_COMMENTS)
        string(REGEX REPLACE "[ ]*//[^\n]*" "" text "${text}")
        string(REGEX REPLACE "\n[\n ]+" "\n" text "${text}")
    endif()
    string(APPEND rows "    {\"${name}\", R\"EMBEDDED(${text})EMBEDDED\"},\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"${HEADER}\"\n
namespace poinsot {\n
const std::vector<${TYPE}>& ${FUNCTION}() {
    static const std::vector<${TYPE}> files{\n${rows}    };
    return files;
}\n
}  // namespace poinsot\n")
