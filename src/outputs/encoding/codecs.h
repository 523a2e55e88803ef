// The encoders that this machine's FFmpeg has, for `poinsot doctor`.
#pragma once

#include <string>
#include <vector>

namespace poinsot {

struct CodecStatus {
    std::string name;  // FFmpeg's name of the encoder
    bool available = false;
    std::string detail;  // its purpose, or the package that provides it
};

std::vector<CodecStatus> codec_statuses();

}  // namespace poinsot
