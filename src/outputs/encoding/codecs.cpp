#include "encoding/codecs.h"

#include <array>

#include "encoding/libav.h"

namespace poinsot {

std::vector<CodecStatus> codec_statuses() {
    struct Row {
        const char* name;
        const char* use;
    };
    constexpr std::array<Row, 4> rows{{{"libx264", "H.264 for .mp4"},
                                       {"libvpx-vp9", "VP9 for .webm"},
                                       {"prores_ks", "ProRes for .mov"},
                                       {"gif", "for .gif"}}};
    std::vector<CodecStatus> statuses;
    for (const Row& row : rows) {
        const bool available = avcodec_find_encoder_by_name(row.name) != nullptr;
        statuses.push_back({row.name, available,
                            available ? row.use : "this FFmpeg lacks it; install libavcodec59"});
    }
    return statuses;
}

}  // namespace poinsot
