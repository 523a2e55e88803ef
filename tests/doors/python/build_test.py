"""What a wheel holds, without a compiler: the files and the metadata."""
import builtins
import importlib.util
import sys
import sysconfig

import pytest

from conftest import ROOT, SCENES


@pytest.fixture
def build():
    spec = importlib.util.spec_from_file_location("poinsot_build", ROOT / "src" / "doors" / "python" / "poinsot_build.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize("has_tomllib", [True, False])
def test_the_metadata_names_what_the_extra_for_notebooks_needs(build, monkeypatch, has_tomllib):
    if has_tomllib and sys.version_info < (3, 11):
        pytest.skip("this Python has no tomllib")
    imported = builtins.__import__

    def without_tomllib(name, *arguments, **options):
        if name == "tomllib" and not has_tomllib:
            raise ImportError(name)
        return imported(name, *arguments, **options)

    monkeypatch.setattr(builtins, "__import__", without_tomllib)
    head = build.metadata().split("\n\n")[0].split("\n")
    assert "Requires-Dist: numpy" in head
    assert head.count("Provides-Extra: notebooks") == 1
    assert [line for line in head if "extra ==" in line] == [
        f'Requires-Dist: {name}; extra == "notebooks"' for name in ("matplotlib", "pandas", "scipy", "tqdm")]


def test_files_that_are_left_in_the_build_folder_do_not_get_into_a_wheel(build, tmp_path):
    package = tmp_path / "python" / "poinsot"
    package.mkdir(parents=True)
    module = "_poinsot" + sysconfig.get_config_var("EXT_SUFFIX")
    for name in (module, "_poinsot.cpython-38-x86_64-linux-gnu.so", "deleted.py", "scene.py"):
        (package / name).write_text("of an older build")
    files = build.package_files(tmp_path)
    assert list(files) == sorted(files)
    assert [name for name, data in files.items() if data == b"of an older build"] == [f"poinsot/{module}"]
    source = ROOT / "src" / "doors" / "python" / "poinsot"
    assert {name for name in files if name.count("/") == 1} == {
        f"poinsot/{module}", "poinsot/py.typed", *(f"poinsot/{file.name}" for file in source.glob("*.py*") if file.is_file())
    }
    assert {name for name in files if name.endswith(".toml") and name.count("/") == 2} == {
        f"poinsot/scenes/{file.name}" for file in SCENES.glob("*.toml")}
