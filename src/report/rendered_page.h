// Pages of vectors as pictures, so that they can be compared as those are.
#pragma once

#include <filesystem>

namespace poinsot {

// Whether a file is a page: .pdf or .svg.
bool is_page_name(const std::filesystem::path& file);

// A folder for pictures of pages, gone with it.
class RenderedPages {
 public:
    // Throws EnvironmentError where no folder can be made.
    RenderedPages();
    ~RenderedPages();
    RenderedPages(const RenderedPages&) = delete;
    RenderedPages& operator=(const RenderedPages&) = delete;

    // A PNG of the page at 300 dots an inch, by pdftoppm (poppler) or rsvg-convert (librsvg); the
    // names tell two pages apart. Throws EnvironmentError where the program is not here, InputError
    // for a file that it cannot read.
    std::filesystem::path picture_of(const std::filesystem::path& page);

 private:
    std::filesystem::path folder_;
    int n_pages_ = 0;
};

}  // namespace poinsot
