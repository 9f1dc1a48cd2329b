"""Runs the validation: python3 main.py [--quick] [--write FILE.md] [--only case,...] [module ...]

Modules (default: added_mass_cases, motion_cases, robustness_cases) have `cases(quick)`, a generator of harness.Row. Every row is printed as it
comes; --write puts them all into a Markdown file, a table a section. Exit status 1 if any row misses its target.
"""
import argparse
import datetime
import importlib
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import harness    # noqa: E402

MODULES = ["added_mass_cases", "motion_cases", "robustness_cases"]


def rows_of(name, quick, only):
    module = importlib.import_module(name)
    try:
        yield from module.cases(quick, only) if only else module.cases(quick)
    except Exception as error:    # noqa: BLE001
        yield harness.Row("Cases that did not run", name, "runs", f"{type(error).__name__}: {str(error)[-300:]}".replace("\n", " "), False)


def markdown(rows, version, seconds):
    failed = sum(not row.ok for row in rows)
    lines = ["# Validation", "", f"Written by `tools/validate`: {version}, {datetime.date.today().isoformat()}, {seconds / 60:.0f} minutes; {len(rows)} rows, "
             + (f"**{failed} miss their target**." if failed else "all meet their targets."),
             "Exact data: `tests/data/reference`. Ranges are lowest … highest error over the placements named.", ""]
    for section in dict.fromkeys(row.section for row in rows):
        lines += [f"## {section}", "", "| case | target | measured | |", "|---|---|---|---|"]
        for row in rows:
            if row.section == section:
                mark = ("met" if row.ok else "**MISSED**") if row.target else "reported"
                lines.append("| " + " | ".join(text.replace("|", "\\|") for text in (row.case, row.target, row.measured, mark)) + " |")
        lines.append("")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true", help="the subset that every change must pass")
    parser.add_argument("--write", metavar="FILE", type=Path, help="Markdown table")
    parser.add_argument("--only", metavar="CASE,...", help="names of case functions of the modules")
    parser.add_argument("module", nargs="*")
    options = parser.parse_args()
    names = options.module or [name for name in MODULES if (Path(__file__).parent / f"{name}.py").exists()]
    only = options.only.split(",") if options.only else None

    version = harness.command(["--version"]).stdout.strip()
    start, rows, section = time.time(), [], None
    for name in names:
        for row in rows_of(name, options.quick, only):
            if row.section != section:
                section = row.section
                print(f"\n{section}", flush=True)
            rows.append(row)
            mark = "ok  " if row.ok else "MISS"
            print(f"  {mark} {row.case}: {row.measured}" + (f"  [{row.target}]" if row.target else ""), flush=True)
    failed = [row for row in rows if not row.ok]
    seconds = time.time() - start
    print(f"\n{len(rows)} rows, {len(failed)} missed, {seconds:.0f} s")
    for row in failed:
        print(f"  MISS {row.section}: {row.case}: {row.measured}  [{row.target}]")
    if options.write:
        options.write.parent.mkdir(parents=True, exist_ok=True)
        options.write.write_text(markdown(rows, version, seconds))
    if not rows:
        print("no rows", file=sys.stderr)
    return 1 if failed or not rows else 0


if __name__ == "__main__":
    sys.exit(main())
