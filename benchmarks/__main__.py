"""Run the benchmarks of SemRef.

    .venv/bin/python -m benchmarks list
    .venv/bin/python -m benchmarks run NAME… [--count N] [--only PARTS] [--save]
    .venv/bin/python -m benchmarks fit NAME… [--only PARTS]
    .venv/bin/python -m benchmarks page

NAME is a file of scenarios/*.toml, or ``NAME.PART`` for a file with several measurements. The folder ``--work`` keeps
label maps, databases and records, so a run with a larger ``--count`` continues.
``--save`` writes results/NAME.json, with _ for the dot.
``fit`` prints the settings that would fit the records. ``page`` writes docs/benchmarks.md and its chart.
"""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path

# Waiting threads of OpenBLAS would count as processor time: twice that of a fix. NumPy reads this.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

ROOT = Path(__file__).resolve().parents[1]
# Our processing/ must not come before QGIS's.
sys.path[:] = [entry for entry in sys.path if Path(entry or ".").resolve() != ROOT]
sys.path.append(str(ROOT / "tools"))

from plugin_package import load_plugin_package  # noqa: E402

load_plugin_package()

from benchmarks import results  # noqa: E402
from benchmarks.toml import read_toml  # noqa: E402

SCENARIOS = Path(__file__).with_name("scenarios")


def scenarios() -> dict[str, dict]:
    """Return the scenarios by name. A table with a ``title`` in a file is a separate scenario."""
    found = {}
    for path in sorted(SCENARIOS.glob("*.toml")):
        content = read_toml(path)
        if "title" in content:
            found[path.stem] = content
        else:
            found |= {f"{path.stem}.{part}": one for part, one in content.items()}
    return found


def main(arguments: list[str] | None = None) -> int:
    """Run the command line."""
    known = scenarios()
    parser = argparse.ArgumentParser("python -m benchmarks", description=__doc__.splitlines()[0])
    parser.add_argument("command", choices=("list", "run", "fit", "page"))
    parser.add_argument("names", nargs="*", metavar="NAME", help="scenario, or file of scenarios for all of them")
    parser.add_argument("--data", type=Path, default=ROOT.parent / "shared" / "data", help="folder of the real data")
    parser.add_argument("--work", type=Path, default=ROOT.parent / "bench", help="folder kept between runs")
    parser.add_argument("--models", type=Path, help="folder of networks, NAME_without_PLACE.onnx")
    parser.add_argument("--count", type=int, help="images or flights per row")
    parser.add_argument("--only", default="", help="rows with one of these texts in the name, separated by semicolons")
    parser.add_argument("--save", action="store_true", help="write results/NAME.json")
    options = parser.parse_args(arguments)
    if options.command == "page":
        from benchmarks import page

        page.write()
    chosen = {}
    for name in options.names:
        some = {one: known[one] for one in known if one == name or one.startswith(f"{name}.")}
        if not some:
            parser.error(f"{name} is unknown. Choose from {', '.join(known)}.")
        chosen |= some
    if options.command == "list":
        print("\n".join(f"{name:20} {one['title']}" for name, one in known.items()))
    elif options.command == "fit":
        from benchmarks import fit

        table = fit.run(options.work, list(chosen), [part for part in options.only.split(";") if part])
        print(results.markdown(table["columns"], table["rows"]))
    elif options.command == "run":
        _run(chosen, options)
    return 0


def _run(chosen: dict[str, dict], options: argparse.Namespace) -> None:
    options.work.mkdir(parents=True, exist_ok=True)
    os.environ["SEMREF_CACHE"] = str(options.work / "cache")
    from qgis_session import qgis_session

    with qgis_session():
        from benchmarks import accuracy, assessment, flights, timing
        from benchmarks.maps import World

        world = World(options.data, options.work, options.models, options.count)
        modules = accuracy, assessment, flights, timing
        runners = {module.__name__.rpartition(".")[2]: module.run for module in modules}
        only = [part for part in options.only.split(";") if part]
        for name, scenario in chosen.items():
            tables = runners[scenario["runner"]](world, name, scenario, only)
            print(f"\n## {scenario['title']}")
            for table in tables:
                print(f"\n{results.markdown(table['columns'], table['rows'])}", flush=True)
            if options.save:
                command = f"python -m benchmarks run {name}" + (f" --count {options.count}" if options.count else "")
                command += f' --only "{options.only}"' if only else ""
                path = results.save(name, scenario["title"], command, scenario.get("notes", []), tables)
                print(f"\n{path}")


if __name__ == "__main__":
    sys.exit(main())
