// Renders vector pages to pictures, so that they can be compared.
#pragma once

#include <filesystem>

#include "error/error.h"

namespace poinsot {

// Whether a file is a page: .pdf or .svg.
bool is_vector_page_name(const std::filesystem::path& file);

// The program that renders a page is not installed.
class NoRasteriser : public EnvironmentError {
 public:
    using EnvironmentError::EnvironmentError;
};

// A temporary folder for pictures of pages; the destructor removes it.
class RenderedPages {
 public:
    // Throws EnvironmentError if no folder can be created.
    RenderedPages();
    ~RenderedPages();
    RenderedPages(const RenderedPages&) = delete;
    RenderedPages& operator=(const RenderedPages&) = delete;

    // Renders a PNG of the page at 300 dots per inch, with pdftoppm (poppler) or rsvg-convert
    // (librsvg); the PNGs of two pages have different names. Throws NoRasteriser, and InputError
    // for a file that the program cannot read.
    std::filesystem::path picture_of(const std::filesystem::path& page);

 private:
    std::filesystem::path folder_;
    int n_pages_ = 0;
};

}  // namespace poinsot
