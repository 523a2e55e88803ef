// A build without the toolchain for browsers has no module.
#include "web/pack/page_parts.h"

namespace poinsot {

std::string_view page_module_lzma() { return {}; }
std::string_view page_fit_module_lzma() { return {}; }
std::string_view page_fonts_lzma() { return {}; }
std::string_view page_scripts_lzma() { return {}; }
std::string_view page_film_writer_lzma() { return {}; }
std::string_view page_film_writer_sha256() { return {}; }
std::string_view page_text_editor_lzma() { return {}; }
std::string_view page_text_editor_sha256() { return {}; }

}  // namespace poinsot
