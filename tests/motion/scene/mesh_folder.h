// A working folder with scenes/wedge.obj, scenes/cover.png and scenes/gyro.csv, for test scenes
// that name files.
#pragma once

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "image/files/png_files.h"

namespace poinsot {

// A right triangular prism, legs and height of one unit, with a corner at the origin.
inline const std::string wedge_obj =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\n"
    "f 1 3 2\nf 4 5 6\nf 1 2 5 4\nf 2 3 6 5\nf 3 1 4 6\n";

// A table of a measured motion.
inline const std::string gyro_csv =
    "time (ms),gyro x (deg/s),gyro y (deg/s),gyro z (deg/s)\n0,0,90,180\n500,0,90,180\n";

// The current folder during its lifetime; removed afterwards.
class MeshFolder {
 public:
    MeshFolder() : before_(std::filesystem::current_path()) {
        std::string name =
            (std::filesystem::temp_directory_path() / "poinsot-scene-XXXXXX").string();
        path_ = ::mkdtemp(name.data());
        std::filesystem::create_directory(path_ / "scenes");
        write("scenes/wedge.obj", wedge_obj);
        write("scenes/gyro.csv", gyro_csv);
        write_png(path_ / "scenes/cover.png", Image(3, 2));
        std::filesystem::current_path(path_);
    }
    ~MeshFolder() {
        std::error_code ignored;
        std::filesystem::current_path(before_, ignored);
        std::filesystem::remove_all(path_, ignored);
    }
    MeshFolder(const MeshFolder&) = delete;
    MeshFolder& operator=(const MeshFolder&) = delete;

    void write(const std::string& name, const std::string& text) const {
        std::ofstream(path_ / name, std::ios::binary) << text;
    }
    const std::filesystem::path& path() const { return path_; }

 private:
    std::filesystem::path before_, path_;
};

}  // namespace poinsot
