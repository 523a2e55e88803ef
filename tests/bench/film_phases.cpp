// film_phases PHASE SCENE SIZE SETTINGS N: the cost of one phase of making a film, as a line of
// JSON. PHASE: render (frames drawn and discarded), encode (the same frames from memory), film
// (both in parallel, as in `poinsot render`). SETTINGS: a quality's name, or an unmodified preset
// of x264 at crf 18. film_bench.py combines the phases.
#include <fmt/format.h>
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "encoding/pipeline.h"
#include "encoding/quality.h"
#include "encoding/video_encoder.h"
#include "encoding/yuv.h"
#include "error/error.h"
#include "production/session/session.h"
#include "production/stills/picture.h"
#include "scene/files/load_scene.h"
#include "tradeoff/measure.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot {
namespace {

// x264 with a given preset; packets are discarded.
class PresetSink : public FrameSink {
 public:
    PresetSink(const OutputPlan& plan, const std::string& preset)
        : converter_(plan.width_px),
          frame_(make_yuv_frame(AV_PIX_FMT_YUV420P, plan.width_px, plan.height_px)),
          packet_(libav::make_packet()),
          encoder_(settings_of(plan, preset), plan.path) {}

    void write(const Image& image) override {
        libav::checked(av_frame_make_writable(frame_.get()), "film", "video frame");
        converter_.convert(image, {frame_->data[0], frame_->data[1], frame_->data[2],
                                   frame_->linesize[0], frame_->linesize[1], frame_->linesize[2]});
        frame_->pts = n_written_++;
        encoder_.send(*frame_);
        drop_packets();
    }
    void finish() override {
        encoder_.send_end();
        drop_packets();
    }

 private:
    static EncoderSettings settings_of(const OutputPlan& plan, const std::string& preset) {
        EncoderSettings settings;
        settings.width_px = plan.width_px;
        settings.height_px = plan.height_px;
        settings.rate = plan.rate;
        settings.n_threads = 3;
        settings.options = {{"preset", preset}, {"crf", "18"}};
        return settings;
    }
    void drop_packets() {
        while (encoder_.receive(*packet_)) av_packet_unref(packet_.get());
    }

    YuvConverter converter_;
    libav::Frame frame_;
    libav::Packet packet_;
    VideoEncoder encoder_;
    std::int64_t n_written_ = 0;
};

bool is_quality(const std::string& settings) {
    const auto known = qualities();
    return std::any_of(known.begin(), known.end(),
                       [&](const Quality& quality) { return quality.name == settings; });
}

std::unique_ptr<FrameSink> open_sink(const OutputPlan& plan, const std::string& settings) {
    if (is_quality(settings)) return format_for(plan.path).open(plan);
    return std::make_unique<PresetSink>(plan, settings);
}

double peak_mib() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

double resident_mib() {
    std::ifstream file("/proc/self/statm");
    long total = 0, resident = 0;
    file >> total >> resident;
    return static_cast<double>(resident * sysconf(_SC_PAGESIZE)) / 1048576.0;
}

struct Film {
    PictureMaker& pictures;
    const FilmPlan& plan;
    std::int64_t n_frames;

    void draw(std::int64_t frame, Image& image) const {
        pictures.draw(plan.moment_of(frame % plan.n_frames), image);
    }
};

void make(const Film& film, FrameSink& sink, const std::vector<Image>& frames) {
    for (const Image& frame : frames) sink.write(frame);
    if (frames.empty()) {
        AsyncSink& queue = dynamic_cast<AsyncSink&>(sink);
        for (std::int64_t k = 0; k < film.n_frames; ++k) {
            Image image = queue.spare();
            film.draw(k, image);
            queue.write_moved(std::move(image));
        }
    }
    sink.finish();
}

int run(const std::string& phase, const std::string& scene, const std::string& size,
        const std::string& settings, std::int64_t n_frames) {
    using Clock = std::chrono::steady_clock;
    std::vector<Override> overrides{{"film.size", size}};
    if (is_quality(settings)) overrides.push_back({"film.quality", settings});
    const Session session = session_of(load_scene(scene, overrides), {installed_fonts()});
    const FilmPlan plan = film_plan(session);
    LazyRenderer renderer;
    PictureMaker pictures(session, renderer, {plan.time_of(0), plan.last_time_s()});
    const Film film{pictures, plan, n_frames};

    OutputPlan output;
    output.path = std::filesystem::temp_directory_path() /
                  ("poinsot-bench-" + std::to_string(getpid()) + ".mp4");
    output.width_px = session.scene.film.width_px;
    output.height_px = session.scene.film.height_px;
    output.rate = plan.rate;
    output.n_frames = n_frames;
    output.quality = settings;

    silence_libav();
    // Shaders are compiled and static contents are cached before the clock starts.
    for (Image image; const std::int64_t k : {0, 1, 2}) film.draw(k, image);
    std::vector<Image> frames;
    if (phase == "encode") {
        frames.resize(static_cast<std::size_t>(n_frames));
        for (std::int64_t k = 0; k < n_frames; ++k)
            film.draw(k, frames[static_cast<std::size_t>(k)]);
    }
    const double resident_before_mib = resident_mib();
    const double cpu_before_s = process_cpu_s();
    const auto started = Clock::now();
    if (phase == "render") {
        Image image;
        for (std::int64_t k = 0; k < n_frames; ++k) film.draw(k, image);
    } else if (phase == "encode") {
        const auto sink = open_sink(output, settings);
        make(film, *sink, frames);
    } else if (phase == "film") {
        AsyncSink sink(open_sink(output, settings));
        make(film, sink, {});
    } else {
        throw InputError(phase + ": no such phase; there are render, encode and film");
    }
    const double wall_s = std::chrono::duration<double>(Clock::now() - started).count();
    const double cpu_s = process_cpu_s() - cpu_before_s;
    std::error_code none;
    const auto bytes = std::filesystem::file_size(output.path, none);
    fmt::print(
        "{{\"phase\": \"{}\", \"size\": \"{}\", \"settings\": \"{}\", \"frames\": {}, "
        "\"wall_s\": {:.4f}, \"cpu_s\": {:.4f}, \"resident_before_mib\": {:.1f}, "
        "\"peak_mib\": {:.1f}, \"bytes\": {}}}\n",
        phase, size, settings, n_frames, wall_s, cpu_s, resident_before_mib, peak_mib(),
        none ? 0 : bytes);
    std::filesystem::remove(output.path, none);
    return 0;
}

}  // namespace
}  // namespace poinsot

int main(int argc, char** argv) {
    if (argc != 6) {
        std::fputs("film_phases render|encode|film SCENE WxH QUALITY|PRESET N\n", stderr);
        return 2;
    }
    // As in the program's main.
    mallopt(M_MMAP_THRESHOLD, 1 << 20);
    try {
        return poinsot::run(argv[1], argv[2], argv[3], argv[4], std::stol(argv[5]));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 3;
    }
}
