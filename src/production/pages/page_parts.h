// What the program carries for its pages: the files of page/, and the module with its fonts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace poinsot {

struct PageFile {
    std::string name;  // "page.css"
    std::string text;
};

// The files of page/.
const std::vector<PageFile>& page_files();

// The program for browsers as WebAssembly, and the glyphs that its pictures need, both compressed
// by LZMA; empty if the program was built without them.
std::string_view page_module_lzma();
std::string_view page_fonts_lzma();

}  // namespace poinsot
