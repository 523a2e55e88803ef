// The GLSL files of shaders/, embedded at build time.
#pragma once

#include <string_view>
#include <vector>

namespace poinsot {

struct ShaderSource {
    std::string_view name;  // file name, e.g. "ellipsoid.frag"
    std::string_view text;
};

const std::vector<ShaderSource>& shader_sources();

}  // namespace poinsot
