// What the program carries for its pages: the files of web/page/, and the module with its fonts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace poinsot {

struct PageFile {
    std::string name;  // "page.css"
    std::string text;
};

// The files of web/page/.
const std::vector<PageFile>& page_files();

// The program for browsers as WebAssembly, and the glyphs that its pictures need, both compressed
// by LZMA; empty if the program was built without them.
std::string_view page_module_lzma();
std::string_view page_fonts_lzma();

// What the workbench measures with, likewise.
std::string_view page_fit_module_lzma();

// The packed scripts of a page, joined as page_scripts.h says.
std::string_view page_scripts_lzma();

// The script that writes films, compressed by LZMA, and the SHA-256 of the script in hexadecimal
// digits. Built without npm's packages, the script is empty.
std::string_view page_film_writer_lzma();
std::string_view page_film_writer_sha256();

// What the workbench edits scenes with, likewise.
std::string_view page_text_editor_lzma();
std::string_view page_text_editor_sha256();

}  // namespace poinsot
