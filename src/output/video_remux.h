// Packets copied from one container into another, unchanged.
#pragma once

#include "image/atomic_file.h"

namespace poinsot {

// Copies the one video stream of a fragmented MP4 into an MP4 with its index in front, so that it
// plays while it loads. Keeps every packet, its times and the metadata.
// Throws: EnvironmentError naming the second file's final path.
void remux_to_faststart(const AtomicFile& fragments, const AtomicFile& whole);

}  // namespace poinsot
