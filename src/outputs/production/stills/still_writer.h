// Writes stills while the next one is drawn: compression and writing take as long as drawing a
// small one.
#pragma once

#include <functional>
#include <future>
#include <optional>

#include "image/image.h"
#include "image/png.h"
#include "production/stills/output_place.h"

namespace poinsot {

// Writes one at a time, in order. Errors of writing are thrown by the next call. The destructor
// waits, and discards errors: call finish() to get them.
class StillWriter {
 public:
    // Returns while the picture is being written; the next call of this object calls `written` once
    // the file is complete. Throws the previous picture's error.
    void write(OutputPlace&& place, Image&& picture, PngOptions&& png,
               std::function<void()>&& written);

    // Waits for the last picture. Throws EnvironmentError as write_png does.
    void finish();

 private:
    std::optional<OutputPlace> place_;  // until the picture is written
    std::future<void> writing_;
    std::function<void()> written_;
};

}  // namespace poinsot
