// approve: portable results become baselines, with a line in the manifest and a reason.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "cli/program_run.h"
#include "cli/recorded_pictures.h"
#include "cli/small_scene.h"
#include "image/files/png_bands.h"
#include "image/files/png_files.h"

namespace poinsot::testing {
namespace {

namespace fs = std::filesystem;

using ApprovedPictures = Pictures;
using ApproveMessages = Messages;

TEST_F(ApprovedPictures, AreBaselinesOnlyIfPortable) {
    draw("new/a.png", "--time 0.1");
    const ProgramRun refused = approve("a");
    EXPECT_EQ(refused.code, 2);
    EXPECT_TRUE(is_one_line(refused.err) && contains(refused.err, "--portable")) << refused.err;
    EXPECT_FALSE(fs::exists(folder_.path() / "ref/a.png"));
    EXPECT_EQ(approve("a --any-renderer").code, 0);
    EXPECT_TRUE(fs::exists(folder_.path() / "ref/a.png"));
}

TEST_F(ApprovedPictures, AreListedWithHashesRendererAndReason) {
    draw("new/a.png", "--portable --time 0.1");
    ASSERT_EQ(approve("a").code, 0);
    const std::string manifest = text_of(folder_.path() / "ref/manifest.toml");
    const std::string explained = run("explain new/a.png").out;
    EXPECT_TRUE(contains(manifest, said(explained, "scene-sha256")));
    EXPECT_TRUE(contains(manifest, said(explained, "renderer")));
    EXPECT_TRUE(contains(manifest, "mesa = \"" + said(explained, "mesa") + "\""));
    EXPECT_TRUE(text_of(folder_.path() / "ref/a.png") == text_of(folder_.path() / "new/a.png"));
    EXPECT_EQ(approve("a").out, "a: unchanged\n");

    // A changed picture needs a reason; without one, no file is changed.
    draw("new/a.png", "--portable --time 0.2");
    const ProgramRun why = approve("a");
    EXPECT_EQ(why.code, 2);
    EXPECT_TRUE(is_one_line(why.err) && contains(why.err, "--why")) << why.err;
    EXPECT_EQ(text_of(folder_.path() / "ref/manifest.toml"), manifest);
    EXPECT_EQ(approve("a --why 'later'").code, 0);
    EXPECT_TRUE(contains(text_of(folder_.path() / "ref/manifest.toml"), "why = \"later\""));
    EXPECT_EQ(run("compare ref new").code, 0);
}

// Pictures of other programs, of 8 and 16 bits, beside our own; the manifest says whose they are.
TEST_F(ApprovedPictures, MayBeByOtherPrograms) {
    draw("drawn.png", "--portable --time 0.1 --depth 16");
    draw("new/ours.png", "--portable --time 0.1");
    const StoredPicture drawn = read_stored_png(folder_.path() / "drawn.png");
    write_png(folder_.path() / "new/eight.png", read_png(folder_.path() / "new/ours.png"));
    {
        PngBandWriter writer(folder_.path() / "new/sixteen.png", drawn.deep.width(),
                             drawn.deep.height(), true, {}, 16);
        writer.write(drawn.deep);
        writer.finish();
    }
    const ProgramRun refused = approve("--all");
    EXPECT_EQ(refused.code, 2);
    EXPECT_TRUE(is_one_line(refused.err) && contains(refused.err, "--foreign")) << refused.err;
    EXPECT_FALSE(fs::exists(folder_.path() / "ref/manifest.toml"));
    ASSERT_EQ(approve("--all --foreign").code, 0);
    const std::string manifest = text_of(folder_.path() / "ref/manifest.toml");
    EXPECT_EQ(std::count(manifest.begin(), manifest.end(), '\n'), 4);
    EXPECT_TRUE(contains(manifest, "renderer = \"another program\"")) << manifest;
    EXPECT_EQ(run("compare ref new").code, 0);
    // Our own picture may be compared with theirs, and the next of ours is approved as before.
    fs::copy(folder_.path() / "new/ours.png", folder_.path() / "new/eight.png",
             fs::copy_options::overwrite_existing);
    EXPECT_EQ(run("compare ref new").code, 0);
    draw("new/more.png", "--portable --time 0.2");
    EXPECT_EQ(approve("more").code, 0);
    // Another size is said.
    write_png(folder_.path() / "new/sixteen.png", Image(20, 10));
    EXPECT_TRUE(
        contains(run("compare ref new").out, "size: sixteen: expected 128×72 pixels, found 20×10"));
}

TEST_F(ApprovedPictures, OfAnotherRendererNeedAnOption) {
    draw("new/a.png", "--portable --time 0.1");
    draw("new/b.png", "--portable --time 0.2");
    ASSERT_EQ(approve("a").code, 0);
    std::string manifest = text_of(folder_.path() / "ref/manifest.toml");
    const std::string mesa = "mesa = \"";
    manifest.insert(manifest.find(mesa) + mesa.size(), "9");
    folder_.write("ref/manifest.toml", manifest);
    const ProgramRun refused = approve("b");
    EXPECT_EQ(refused.code, 2);
    EXPECT_TRUE(is_one_line(refused.err) && contains(refused.err, "--any-renderer")) << refused.err;
    EXPECT_EQ(approve("b --any-renderer").code, 0);
}

// compare reports a baseline that is not the approved picture, and approve restores it.
TEST_F(ApprovedPictures, ThatDoNotMatchTheManifestAreReported) {
    draw("new/a.png", "--portable --time 0.1");
    ASSERT_EQ(approve("a").code, 0);
    draw("ref/a.png", "--portable --time 0.2");
    for (const char* both : {"ref new", "ref/a.png new/a.png"}) {
        const ProgramRun compared = run(std::string("compare ") + both);
        EXPECT_EQ(compared.code, 1);
        EXPECT_TRUE(contains(compared.out, "baseline: a: ")) << compared.out;
    }
    const ProgramRun back = approve("a");
    EXPECT_EQ(back.code, 0) << back.err;
    EXPECT_TRUE(contains(back.out, "a: restored; the baseline did not match the manifest"))
        << back.out;
    EXPECT_EQ(run("compare ref new").code, 0);
    EXPECT_EQ(approve("a").out, "a: unchanged\n");
}

// A baseline that no picture needs any more leaves with its line; nothing is removed if a name is
// wrong.
TEST_F(ApprovedPictures, AreRemovedByName) {
    for (const char* name : {"old", "kept"})
        draw(std::string("new/") + name + ".png", "--portable --time 0.1");
    ASSERT_EQ(approve("--all").code, 0);
    const ProgramRun refused = run("approve --remove old kep --baselines ref");
    EXPECT_EQ(refused.code, 2);
    EXPECT_TRUE(is_one_line(refused.err) &&
                contains(refused.err, "kep: no baseline of that name in ref") &&
                contains(refused.err, "did you mean \"kept\"?"))
        << refused.err;
    EXPECT_TRUE(fs::exists(folder_.path() / "ref/old.png"));
    fs::remove(folder_.path() / "new/old.png");
    EXPECT_TRUE(contains(run("compare ref new").out, "missing: old: "));
    const ProgramRun removed = run("approve --remove old.png --baselines ref --why 'renamed'");
    EXPECT_EQ(removed.code, 0) << removed.err;
    EXPECT_EQ(removed.out, "old: removed: renamed\n");
    EXPECT_FALSE(fs::exists(folder_.path() / "ref/old.png"));
    EXPECT_FALSE(contains(text_of(folder_.path() / "ref/manifest.toml"), "old"));
    EXPECT_EQ(run("compare ref new").code, 0);
    // A line whose picture was removed by hand.
    fs::remove(folder_.path() / "ref/kept.png");
    EXPECT_TRUE(contains(run("compare ref new").out, "approve --remove"));
    EXPECT_EQ(run("approve --remove kept --baselines ref").code, 0);
    EXPECT_TRUE(contains(run("compare ref new").out, "unexpected: kept: "));
    EXPECT_EQ(run("approve --remove kept --baselines nowhere").code, 2);
    EXPECT_FALSE(fs::exists(folder_.path() / "nowhere"));
}

// Films and vector figures, named with their suffix, have hash and reason as pictures have.
TEST_F(ApprovedPictures, MayBeFilmsAndFigures) {
    draw("new/still.png", "--portable --time 0.1");
    draw("new/figure.pdf", "--time 0.1");
    ASSERT_EQ(run("render scene.toml -q --portable --frames 0-2 -o new/film.gif").code, 0);
    ASSERT_EQ(run("render scene.toml -q --frames 0-2 -o new/native.gif").code, 0);
    EXPECT_TRUE(contains(approve("native.gif").err, "drawn without --portable"));
    fs::remove(folder_.path() / "new/native.gif");
    const ProgramRun approved = approve("--all --why 'the first'");
    ASSERT_EQ(approved.code, 0) << approved.err;
    EXPECT_EQ(approved.out, "figure.pdf: new\nfilm.gif: new\nstill: new\n");
    const std::string manifest = text_of(folder_.path() / "ref/manifest.toml");
    EXPECT_TRUE(contains(manifest, "\"figure.pdf\" = {") && contains(manifest, "\"film.gif\" = {"))
        << manifest;
    for (const char* name : {"figure.pdf", "film.gif"})
        EXPECT_EQ(text_of(folder_.path() / "ref" / name), text_of(folder_.path() / "new" / name));
    EXPECT_EQ(run("compare ref new").code, 0);
    EXPECT_EQ(run("compare ref/film.gif new/film.gif").code, 0);
    EXPECT_EQ(approve("film.gif").out, "film.gif: unchanged\n");

    // Another film needs a reason; a baseline that is not the approved film is reported.
    ASSERT_EQ(run("render scene.toml -q --portable --frames 1-3 -o new/film.gif").code, 0);
    EXPECT_TRUE(contains(approve("film.gif").err, "--why"));
    fs::copy(folder_.path() / "new/film.gif", folder_.path() / "ref/film.gif",
             fs::copy_options::overwrite_existing);
    EXPECT_TRUE(contains(run("compare ref new").out, "baseline: film.gif: ")) << manifest;
    EXPECT_EQ(approve("film.gif --why 'later'").code, 0);
    EXPECT_EQ(run("compare ref new").code, 0);
    EXPECT_EQ(run("approve --remove film.gif --baselines ref").out, "film.gif: removed\n");
    EXPECT_FALSE(fs::exists(folder_.path() / "ref/film.gif"));
    EXPECT_TRUE(contains(approve("gone.mp4").err, "new/gone.mp4 does not exist"));
}

TEST_F(ApprovedPictures, ConcurrentlyAllHaveTheirLines) {
    for (const char* name : {"a", "b", "c", "d"})
        draw(std::string("new/") + name + ".png", "--portable --time 0.1");
    const std::string approve =
        "'" + program_path() + "' approve -q --results new --baselines ref ";
    const std::string both =
        "cd '" + folder_.path().string() + "' && (" + approve + "a b & " + approve + "c d & wait)";
    ASSERT_EQ(std::system(both.c_str()), 0);
    EXPECT_EQ(run("compare ref new").out, "4 compared, 0 failed, 4 the same\n");
}

TEST_F(ApprovedPictures, StayInTheirFolder) {
    draw("a.png", "--portable --time 0.1");
    for (const char* name : {"../a", "/etc/passwd", "b/../../a"}) {
        const ProgramRun refused = approve(name);
        EXPECT_EQ(refused.code, 2) << name;
        EXPECT_TRUE(is_one_line(refused.err)) << refused.err;
    }
    EXPECT_FALSE(fs::exists(folder_.path() / "ref/manifest.toml"));
}

TEST_F(ApproveMessages, ADifferentBaselineIsNotReplacedWithoutAReason) {
    fs::create_directory(folder_.path() / "new");
    fs::create_directory(folder_.path() / "ref");
    ASSERT_EQ(run("still scene.toml --portable --time 0.9 -o new/a.png").code, 0);
    ASSERT_EQ(run("still scene.toml --portable --time 0 -o ref/a.png").code, 0);
    const std::string before = text_of(folder_.path() / "ref/a.png");
    // The manifest has no line for it.
    for (const char* what : {"a", "--all"}) {
        const ProgramRun refused =
            run(std::string("approve ") + what + " --results new --baselines ref");
        EXPECT_EQ(refused.code, 2);
        EXPECT_NE(refused.err.find("--why"), std::string::npos) << refused.err;
        EXPECT_EQ(text_of(folder_.path() / "ref/a.png"), before);
    }
    EXPECT_EQ(run("approve a --results new --baselines ref --why 'the other end'").code, 0);
    EXPECT_EQ(text_of(folder_.path() / "ref/a.png"), text_of(folder_.path() / "new/a.png"));
    // An equal picture or a new one needs no reason.
    fs::copy(folder_.path() / "new/a.png", folder_.path() / "new/b.png");
    EXPECT_EQ(run("approve --all --results new --baselines ref").code, 0);
}

// A picture of another program is no baseline, whatever renderer drew it.
TEST_F(ApproveMessages, APictureWithoutARecordIsNamedSo) {
    fs::create_directories(folder_.path() / "results");
    write_png(folder_.path() / "results/other.png", Image(4, 4));
    refuses("approve other --any-renderer --results results --baselines base", 2,
            {"results/other.png: has no record of how it was made", "draw it with poinsot",
             "--foreign"});
    refuses("explain results/other.png", 2, {"has no record of how it was made"});
}

}  // namespace
}  // namespace poinsot::testing
