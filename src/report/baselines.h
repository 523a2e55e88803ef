// A folder of baseline pictures as a whole: the pictures, their manifest, and how each stands to
// its line in it.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "report/baseline_manifest.h"
#include "system/atomic_file.h"

namespace poinsot {

// The hash of a file's pixels; empty if it is no whole PNG, or not there.
std::string pixel_hash_of_file(const std::filesystem::path& picture);

// To read from. A folder without a manifest says nothing of its pictures.
class Baselines {
 public:
    // Throws: as read_manifest.
    explicit Baselines(std::filesystem::path folder);

    // Or the beginnings of one, left by an approval that was interrupted.
    bool has_manifest() const { return has_manifest_; }
    const BaselineManifest& manifest() const { return manifest_; }
    std::filesystem::path picture(const std::string& name) const;

    // What keeps this picture, whose pixels have a hash, from being the one that was approved, one
    // line; empty if nothing does, or where there is no manifest.
    std::string fault(const std::string& name, const std::string& pixels) const;

 private:
    std::filesystem::path folder_;
    bool has_manifest_ = false;
    BaselineManifest manifest_;
    std::optional<BaselineManifest> next_;
};

// To write to: one at a time, others wait. A run killed at any moment leaves each picture with the
// line it had or with its new one, or what the next to write needs in order to finish.
class BaselineWriter {
 public:
    // Makes the folder where there is none. Calls when_held before it waits. Throws:
    // EnvironmentError; as read_manifest.
    explicit BaselineWriter(
        std::filesystem::path folder, const std::function<void()>& when_held = [] {});
    ~BaselineWriter();  // a folder that was made and is still empty goes
    BaselineWriter(const BaselineWriter&) = delete;
    BaselineWriter& operator=(const BaselineWriter&) = delete;

    const BaselineManifest& manifest() const { return manifest_; }
    // Pictures whose lines an interrupted run had not written, and that have them now.
    const std::vector<std::string>& finished() const { return finished_; }

    std::string pixels_of(const std::string& name) const;  // of the picture that is there

    struct Change {
        std::string name;
        std::filesystem::path from;  // the picture that is copied
        Baseline line;
    };
    // Copies the pictures and writes their lines. Throws EnvironmentError; lines of those pictures
    // that were copied by then are written if they can be.
    void take(const std::vector<Change>& changes);

 private:
    void finish_interrupted();

    std::filesystem::path folder_;
    bool made_;
    std::optional<AtomicFile> lock_;
    BaselineManifest manifest_;
    std::vector<std::string> finished_;
};

}  // namespace poinsot
