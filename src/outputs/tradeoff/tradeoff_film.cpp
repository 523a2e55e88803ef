// Speed versus similarity and size for the encoder's settings, for one scene: the same frames from
// memory.
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "compare/compare.h"
#include "encoding/frame_sink.h"
#include "encoding/quality.h"
#include "encoding/video_reader.h"
#include "error/error.h"
#include "production/stills/picture.h"
#include "tradeoff/measure.h"
#include "tradeoff/tradeoff.h"

namespace poinsot {

namespace {

// A temporary folder with an unpredictable name that only this process may enter; the destructor
// removes it with its contents.
class TemporaryFolder {
 public:
    TemporaryFolder() {
        std::string name =
            (std::filesystem::temp_directory_path() / "poinsot-tradeoff-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr)
            throw EnvironmentError(fmt::format("cannot make a folder in {}: {}",
                                               std::filesystem::temp_directory_path().string(),
                                               std::strerror(errno)));
        path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

 private:
    std::filesystem::path path_;
};

}  // namespace

FilmTrades trade_film(const Session& session, const ContextChoice& choice, const FilmPlan& film) {
    // Half the film's sides and two seconds: enough to distinguish the presets.
    Session small = session;
    FilmTrades trades;
    const auto half_even = [](int side) { return std::max(16, side / 4 * 2); };
    trades.width_px = small.scene.film.width_px = half_even(session.scene.film.width_px);
    trades.height_px = small.scene.film.height_px = half_even(session.scene.film.height_px);
    small.accuracy = accuracy_of(small.scene);
    trades.n_frames = std::min<std::int64_t>(film.n_frames, 60);

    const OffscreenContext context = make_context(choice);
    PictureMaker maker(small, context, {film.time_of(0), film.last_time_s()}, {1.0, 1});
    std::vector<Image> frames(static_cast<std::size_t>(trades.n_frames));
    for (std::size_t k = 0; k < frames.size(); ++k) {
        maker.draw(film.moment_of(static_cast<std::int64_t>(k)), frames[k]);
    }

    const TemporaryFolder folder;
    const std::filesystem::path path = folder.path() / "film.mp4";
    for (const Quality& quality : qualities()) {
        OutputPlan plan;
        plan.path = path;
        plan.width_px = trades.width_px;
        plan.height_px = trades.height_px;
        plan.rate = film.rate;
        plan.n_frames = trades.n_frames;
        plan.quality = quality.name;
        const Timing timing = timed(
            [&] {
                const auto sink = format_for(path).open(plan);
                for (const Image& frame : frames) sink->write(frame);
                sink->finish();
            },
            3, 3, 0.0);

        FilmTrade row;
        row.quality = quality.name;
        row.ms_a_frame = timing.cpu_s / static_cast<double>(frames.size()) * 1e3;
        row.bytes_a_frame = static_cast<double>(std::filesystem::file_size(path)) /
                            static_cast<double>(frames.size());
        VideoReader reader(path);
        Image decoded;
        double sum = 0.0;
        int n_compared = 0;
        for (std::size_t k = 0; reader.read(decoded); ++k) {
            if (k % 10 != 5) continue;
            sum += structural_similarity(frames[k], decoded);
            ++n_compared;
        }
        row.ssim = n_compared > 0 ? sum / n_compared : 0.0;
        row.unlikeness = 1.0 - row.ssim;
        trades.rows.push_back(row);
    }
    mark_front(trades.rows, &FilmTrade::ms_a_frame, &FilmTrade::unlikeness);
    return trades;
}

}  // namespace poinsot
