# Writes a C++ table of every shader (file name → text). Usage: cmake -DOUTPUT=… -DSHADERS=… -P embed_shaders.cmake
set(rows "")
foreach(file IN LISTS SHADERS)
    get_filename_component(name ${file} NAME)
    file(READ ${file} text)
    string(APPEND rows "    {\"${name}\", R\"GLSL(${text})GLSL\"},\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"render/shader_sources.h\"\n
namespace poinsot {\n
const std::vector<ShaderSource>& shader_sources() {
    static const std::vector<ShaderSource> sources{\n${rows}    };
    return sources;
}\n
}  // namespace poinsot\n")
