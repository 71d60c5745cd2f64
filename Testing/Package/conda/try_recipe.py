# SPDX-License-Identifier: BSD-3-Clause
"""What of recipe.yaml can be tried without conda's channels: it is rendered for each platform, and the packages are
built with this system's compiler, CMake, Ninja and Python in place of conda's. Contents are tested; that Python imports
its package is not, as the test needs conda's Python.

    python3 try_recipe.py FOLDER      needs PyPI, for py-rattler-build; packages for Linux come into FOLDER/packages
"""

import os
import pathlib
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
RECIPE = HERE / "recipe.yaml"
PLATFORMS = ("linux-64", "linux-aarch64", "osx-64", "osx-arm64")
VARIANT = {"c_compiler": ["gcc"], "cxx_compiler": ["gxx"], "c_stdlib": ["sysroot"], "python": ["3.12"]}
PYTHON = "adaptivehilbertdelaunay"  # the package for it


def render(build, path, platform):
    recipe = build.Stage0Recipe.from_file(str(path))
    config = build.RenderConfig(platform=build.PlatformConfig(target_platform=platform))
    return recipe.render(build.VariantConfig(VARIANT), config)


def without_channels(folder):
    """The recipe, which needs nothing from a channel. Its Python is this one, and installs below the prefix."""
    import yaml

    recipe = yaml.safe_load(RECIPE.read_text(encoding="utf-8"))
    recipe["source"]["path"] = str(HERE.parents[2])
    for output in recipe["outputs"]:
        del output["requirements"]
        if output["package"]["name"] == PYTHON:
            script = output["build"]["script"].replace("${{ PYTHON }}", sys.executable)
            output["build"]["script"] = script + " --prefix $PREFIX --config-settings=build-dir=engine"
            files = ["lib/python*/*-packages/%s/*.%s" % (PYTHON, suffix) for suffix in ("so", "py")]
            output["tests"] = [{"package_contents": {"files": files}}]
    path = folder / "recipe.yaml"
    path.write_text(yaml.safe_dump(recipe), encoding="utf-8")
    return path


def try_all(folder):
    import rattler_build as build

    for platform in PLATFORMS:
        found = render(build, RECIPE, platform)
        print(platform, *found)
        assert len(found) == 2, found
    assert not render(build, RECIPE, "win-64"), "there is a package for Windows"
    for package in render(build, without_channels(folder), "linux-64"):
        made = package.run_build(
            tool_config=build.ToolConfiguration(test_strategy="native"), output_dir=str(folder / "packages"),
            channels=[], env_isolation=build.EnvironmentIsolation.NONE)  # fmt: skip
        print(*made.packages)


def main():
    folder = pathlib.Path(sys.argv[1]).resolve()
    python = folder / "tools" / "bin" / "python"
    if sys.argv[2:] == ["tools"]:
        return try_all(folder)
    shutil.rmtree(folder / "packages", ignore_errors=True)
    if not python.exists():
        folder.mkdir(parents=True, exist_ok=True)
        subprocess.run([sys.executable, "-m", "venv", folder / "tools"], check=True)
        install = [python, "-m", "pip", "install", "-q", "py-rattler-build", "pyyaml", "scikit-build-core"]
        subprocess.run(install, check=True)
    words = [os.fspath(python), os.path.abspath(__file__), os.fspath(folder), "tools"]
    return subprocess.run(words, check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
