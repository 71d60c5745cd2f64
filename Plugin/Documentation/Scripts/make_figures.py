# SPDX-License-Identifier: BSD-3-Clause
"""What make_figures.sh runs in pvbatch (with --plots: in any Python): draws the figures, writes the page.

    pvbatch make_figures.py --plugin AdaptiveHilbertDelaunay.so [options]   (see make_figures.sh --help)
"""

import argparse
import json
import os
import sys
import traceback

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
BENCHMARKS = os.path.normpath(os.path.join(HERE, "..", "..", "..", "Testing", "Benchmarks"))
PAPER = os.path.join(BENCHMARKS, "PaperTables.json")

import page
import plots


def parse(words):
    parser = argparse.ArgumentParser(prog="make_figures.sh", add_help=False, allow_abbrev=False)
    parser.add_argument("--plugin")
    parser.add_argument("--plots", action="store_true")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--only", type=lambda names: names.split(","))
    parser.add_argument("--results", default=os.path.join(BENCHMARKS, "Results.json"))
    parser.add_argument("--output", default=os.path.dirname(HERE))
    return parser.parse_args(words)


def figures_from_the_plugin(plugin, paper, quick=False):
    """{name: function(path)}, drawn by ParaView."""
    from paraview import simple

    simple.LoadPlugin(os.path.abspath(plugin), remote=False)
    import scenes
    import stage

    if quick:
        stage.Panel.scale = 0.4
        scenes.MANY, scenes.COUNTED, scenes.STEPPED = 2000, 2000, 40
    return scenes.figures(paper)


def draw_recipes(output, only=None):
    """The pictures of Recipes.md; that page is made by help_page.py."""
    import recipe_pictures

    recipe_pictures.draw(os.path.join(output, "Figures"), only=only)


def draw(chosen):
    """Draws what is chosen; the numbers of all figures there are, those drawn earlier included."""
    results = plots.read(chosen.results, PAPER)
    functions = {}
    if not chosen.plots:
        functions = figures_from_the_plugin(chosen.plugin, results.paper, chosen.quick)
    functions.update(plots.figures(results))
    recipes = [name for name in chosen.only or () if name.startswith("recipe-")]
    if recipes and not chosen.plots:
        draw_recipes(chosen.output, [name[len("recipe-") :] for name in recipes])
        chosen.only = [name for name in chosen.only if name not in recipes]
    elif not chosen.plots and not chosen.only and not chosen.quick:
        draw_recipes(chosen.output)
    unknown = [name for name in chosen.only or () if name not in functions]
    if unknown:
        raise SystemExit(
            "make_figures.sh: no such figure: %s; there are %s" % (unknown[0], ", ".join(functions))
        )
    store = os.path.join(chosen.output, "Figures", "numbers.json")
    numbers = {}
    if os.path.exists(store):
        with open(store, encoding="utf-8") as file:
            numbers = json.load(file)
    for name in functions if chosen.only is None else chosen.only:
        numbers[name] = functions[name](os.path.join(chosen.output, "Figures", name + ".png"))
    os.makedirs(os.path.dirname(store), exist_ok=True)
    text = json.dumps(numbers, indent=1, sort_keys=True) + "\n"
    with open(store, "w", encoding="utf-8") as file:
        file.write(text)
    return numbers


def main():
    chosen = parse(sys.argv[1:])
    page.write(chosen.output, draw(chosen))


def run():
    """The exit code of main."""
    try:
        main()
    except SystemExit as stop:
        print(stop.code, file=sys.stderr) if isinstance(stop.code, str) else None
        return 2 if stop.code else 0
    except Exception:
        traceback.print_exc()
        return 1
    return 0


if __name__ == "__main__":
    code = run()
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(code)  # pvbatch does not pass on the code of sys.exit
