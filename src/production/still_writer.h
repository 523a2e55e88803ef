// Stills are written while the next is drawn: compressing one and waiting for the disk takes as
// long as drawing a small one.
#pragma once

#include <functional>
#include <future>
#include <optional>

#include "image/image.h"
#include "image/png.h"
#include "production/output_place.h"

namespace poinsot {

// One at a time, in order. What writing throws arrives at the next call. Destroyed, it waits, and
// what was not asked for is lost: finish() asks.
class StillWriter {
 public:
    // Returns while the picture is being written; `written` is called by the next call of this
    // object once it is there. Throws what the one before threw.
    void write(OutputPlace&& place, Image&& picture, PngOptions&& png,
               std::function<void()>&& written);

    // Waits for the last. Throws EnvironmentError as write_png does.
    void finish();

 private:
    std::optional<OutputPlace> place_;  // until the picture lies there
    std::future<void> writing_;
    std::function<void()> written_;
};

}  // namespace poinsot
