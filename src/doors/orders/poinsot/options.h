// Options of pictures that the command line, the library and Python share.
#pragma once

#include <optional>
#include <string>

namespace poinsot::library {

// How pictures are drawn. `backend`: auto, osmesa, egl or gpu. `portable`: the same bytes on every
// x86-64 processor; the first picture of a process must ask for it.
struct ContextOptions {
    std::string backend = "auto";
    bool portable = false;
};

// The size on paper: millimetres, dots per inch, points. As the options of `poinsot still`.
struct PaperOptions {
    std::optional<double> width_mm{}, height_mm{}, dpi{}, type_pt{};
    std::string journal{};
    bool keep_text = false;  // with a journal: draw title, captions and clock, too
};

}  // namespace poinsot::library
