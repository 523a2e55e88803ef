// The XML of a presentation. Source: ISO/IEC 29500-1 and -4 (PresentationML), and [MS-PPTX] 2.2.4
// for embedded films.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "production/slides/slide_origin.h"

namespace poinsot {

// A slide that is filled by a film, which starts by itself. Until it starts, the slide shows the
// poster; print-outs show the still, with which the film ends. The next press shows the loop, which
// repeats.
struct PptxSlide {
    std::string title{}, note{};
    std::string film{}, poster{}, loop{}, still{};  // names in ppt/media; loop may be empty
    std::int64_t duration_ms = 0, loop_ms = 0;
};

struct PptxText {
    std::string title;  // of the presentation
    SlideOrigin origin;
    std::string language;             // such as "en"
    int width_px = 0, height_px = 0;  // of the films
    std::vector<PptxSlide> slides;
};

struct PptxPart {
    std::string name, xml;
};

// The part that holds the presentation's description.
inline constexpr std::string_view pptx_origin_name = "docProps/core.xml";

// Whether such a part is that of a presentation of the same talk.
bool describes_slides_of(const SlideOrigin& origin, std::string_view origin_xml);

// All parts but the media; the first one is the list of types, as readers expect.
std::vector<PptxPart> pptx_parts(const PptxText& text);

}  // namespace poinsot
