// Which encoders this machine's FFmpeg has: for `poinsot doctor`.
#pragma once

#include <string>
#include <vector>

namespace poinsot {

struct CodecStatus {
    std::string name;  // FFmpeg's name of the encoder
    bool available = false;
    std::string detail;  // what it is for, or which package brings it
};

std::vector<CodecStatus> codec_statuses();

}  // namespace poinsot
