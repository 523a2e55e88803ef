// A folder of baseline pictures: the pictures, their manifest, and whether each picture matches its
// line in it.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/baseline_manifest.h"
#include "system/files/atomic_file.h"

namespace poinsot {

// Returns the hash of a PNG's pixels, or of the bytes of a film or a vector figure; empty if the
// file is missing or not a complete PNG.
std::string pixel_hash_of_file(const std::filesystem::path& picture);

// Whether a baseline of this name is a film or a vector figure; their names have their suffix.
bool has_suffix_in_name(const std::string& name);

// Reads a folder of baselines. Without a manifest nothing is known about its pictures.
class Baselines {
 public:
    // Throws like read_manifest.
    explicit Baselines(std::filesystem::path folder);

    // Also true for a manifest that an interrupted approval has begun.
    bool has_manifest() const { return has_manifest_; }
    const BaselineManifest& manifest() const { return manifest_; }
    std::filesystem::path picture(const std::string& name) const;

    // Returns the reason, in one line, why this picture, whose pixels have a hash, is not the
    // approved one; empty if it is, or if there is no manifest.
    std::string fault(const std::string& name, const std::string& pixels) const;

 private:
    std::filesystem::path folder_;
    bool has_manifest_ = false;
    BaselineManifest manifest_;
    std::optional<BaselineManifest> next_;
};

// Writes a folder of baselines, one process at a time; others wait. If a run is killed, each
// picture has its old or its new line, or the folder contains the data with which the next writer
// finishes the change.
class BaselineWriter {
 public:
    // Creates the folder if it is missing. Calls when_held before it waits. Throws:
    // EnvironmentError; like read_manifest.
    explicit BaselineWriter(
        std::filesystem::path folder, const std::function<void()>& when_held = [] {});
    ~BaselineWriter();  // removes a folder that it created and that is still empty
    BaselineWriter(const BaselineWriter&) = delete;
    BaselineWriter& operator=(const BaselineWriter&) = delete;

    const BaselineManifest& manifest() const { return manifest_; }
    // Pictures whose lines an interrupted run had not written, and which this object has written.
    const std::vector<std::string>& finished() const { return finished_; }

    std::string pixels_of(const std::string& name) const;  // of the current picture
    std::filesystem::path picture(const std::string& name) const;

    struct Change {
        std::string name;
        std::filesystem::path from;  // the picture to be copied
        Baseline line;
    };
    // Copies the pictures and writes their lines, then removes the baselines with these names and
    // their lines. Throws EnvironmentError; before that it writes, if possible, the lines of the
    // pictures that were already copied.
    void take(const std::vector<Change>& changes, const std::vector<std::string>& removed = {});

 private:
    void finish_interrupted();

    std::filesystem::path folder_;
    bool made_;
    std::optional<AtomicFile> lock_;
    BaselineManifest manifest_;
    std::vector<std::string> finished_;
};

}  // namespace poinsot
