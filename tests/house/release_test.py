#!/usr/bin/env python3
"""The script .ci/release in a mock of the sources: what it replaces, what it refuses, where it writes."""
import os
import pathlib
import shutil
import subprocess
import sys
import tarfile
import tempfile

SOURCES = pathlib.Path(__file__).resolve().parents[2]


def files(folder):
    return {str(file.relative_to(folder)): os.readlink(file) if file.is_symlink() else file.read_bytes()
            for file in sorted(folder.rglob("*")) if file.is_symlink() or file.is_file()}


def git(tree, *words):
    subprocess.run(["git", "-c", "user.name=a", "-c", "user.email=a@b", *words], cwd=tree, check=True, capture_output=True)


def mock(tree):
    """A tree in which the build takes no time."""
    for name in (".ci", "build/release-files", "src/cmake", "docs"):
        (tree / name).mkdir(parents=True)
    shutil.copy(SOURCES / ".ci/release", tree / ".ci/release")
    (tree / ".ci/setup").write_text("")
    (tree / ".gitignore").write_text("build/\noutput/\n")
    (tree / "src/cmake/make_site.py").write_text(
        "import pathlib, sys\nsite = pathlib.Path(sys.argv[3])\nsite.mkdir()\n(site / 'index.html').write_text('site')\n")
    program = tree / "build/release-files/poinsot"
    program.write_text("#!/bin/sh\necho poinsot 1.2.3\n")
    program.chmod(0o755)
    for name in ("poinsot-1.tar.xz", "a.deb", "a.whl", "poinsot.html"):
        (tree / "build/release-files" / name).write_text(name)


def release(tree, *words, within=None):
    return subprocess.run(["sh", str(tree / ".ci/release"), *words], cwd=within or tree, capture_output=True, text=True)


def refused(done, words):
    assert done.returncode == 1 and done.stderr.startswith("release: ") and done.stderr.count("\n") == 1, done
    assert words in done.stderr, done.stderr


def main():
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch).resolve()
        tree = scratch / "tree"
        mock(tree)
        # Without a repository there is no archive; nor with one that only holds the tree.
        refused(release(tree, str(scratch / "out")), "is no git repository")
        git(scratch, "init", "-q")
        refused(release(tree, str(scratch / "out")), "is no git repository")
        assert not (scratch / "out").exists()
        shutil.rmtree(scratch / ".git")
        git(tree, "init", "-q")
        git(tree, "add", ".")
        git(tree, "commit", "-q", "-m", "a")

        # The working tree, a folder with files of its own, a file and a link are not touched.
        (scratch / "mine/inner").mkdir(parents=True)
        (scratch / "mine/SHA256SUMS").write_text("mine")
        (scratch / "mine/inner/.hidden").write_text("mine")
        (scratch / "file").write_text("mine")
        (scratch / "link").symlink_to("mine")
        before = files(scratch)
        for place, words in ((".", "holds other files"), ("..", "holds other files"), ("../mine", "holds other files"),
                             ("../file", "is no folder"), ("../link", "is no folder")):
            refused(release(tree, place), words)
        assert files(scratch) == before

        # A relative folder counts from where one stands; the archive holds the sources.
        work = scratch / "work"
        work.mkdir()
        done = release(tree, "out", within=work)
        assert done.returncode == 0, done
        out = work / "out"
        with tarfile.open(out / "poinsot-1.2.3.tar.gz") as archive:
            assert "poinsot-1.2.3/.ci/release" in archive.getnames()
        subprocess.run(["sha256sum", "--check", "--strict", "--quiet", "SHA256SUMS"], cwd=out, check=True)

        # Its own files are replaced, also if the new release has fewer.
        (tree / "build/release-files/a.deb").rename(tree / "build/release-files/b.deb")
        assert release(tree, "out", within=work).returncode == 0
        assert not (out / "a.deb").exists() and (out / "b.deb").exists() and (out / "site/index.html").exists()

        # A file that was added or edited since stays, wherever it is.
        for name, words in (("notes.txt", "holds other files"), (".hidden", "holds other files"), ("site/mine.html", "holds other files"),
                            ("poinsot.html", "is not as a release left it"), ("site/index.html", "is not as a release left it")):
            there = (out / name).read_bytes() if (out / name).exists() else None
            (out / name).write_text("mine")
            before = files(out)
            refused(release(tree, str(out)), words)
            assert files(out) == before
            (out / name).unlink() if there is None else (out / name).write_bytes(there)
        assert release(tree, str(out)).returncode == 0

        # Uncommitted changes, and a default folder in the sources wherever one stands.
        (tree / "new").write_text("")
        refused(release(tree), "has changes")
        (tree / "new").unlink()
        assert release(tree, within=work).returncode == 0
        assert (tree / "output/release/SHA256SUMS").exists()


if __name__ == "__main__":
    sys.exit(main())
