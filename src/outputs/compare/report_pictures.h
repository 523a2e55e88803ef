// The pictures that a report shows: files in a folder beside it, or thumbnails inside it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "compare/compared_picture.h"
#include "system/files/own_files.h"

namespace poinsot {

// Rows of expected | difference × 16 | actual of a film's worst frames, no wider than most_px.
Image film_strip(std::span<const KeptFrames> frames, int most_px);

class ReportPictures {
 public:
    // Removes the pictures that an earlier report has left in its folder, and throws as
    // check_replaceable does for others of such names. With single_file nothing is written:
    // pictures are made small and embedded in the page.
    ReportPictures(const std::filesystem::path& report, bool single_file);

    // "report_pictures" beside "report.html".
    static std::filesystem::path folder_of(const std::filesystem::path& report);

    // Takes the pictures of a pair; any thread may call it. Throws EnvironmentError.
    void add(ComparedPicture& picture, const PicturePair& pair);

    // Takes the pictures of a file that has no other to be compared with, if it is a PNG.
    void add_alone(ComparedPicture& picture);

 private:
    // Returns the address of a picture in the page.
    std::string put(const std::string& name, const char* which, const Image& image);
    std::string put_file(const std::string& name, const char* which,
                         const std::filesystem::path& file);
    std::string write(const std::string& name, const char* which,
                      const std::vector<std::uint8_t>& png);

    std::filesystem::path folder_;
    bool single_file_;
    std::mutex made_folder_;
    std::optional<FileLog> log_;  // of the folder
    bool has_begun_ = false;      // the list of this report
};

}  // namespace poinsot
