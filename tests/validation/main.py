"""Runs the validation: python3 main.py [--quick] [--write FILE.md | --into FILE.md] [--rows FILE.json] [--only case,...] [--model parts] [module ...]

Modules (default: all of MODULES, in their order) have ALL, a list of case functions: each takes `quick` and
generates harness.Row. Every row is printed as it comes; --write puts them all into a Markdown file, a table a section; --into puts the sections that
were run in place of those of the same name in such a file, or at its end (a section is replaced as a whole: run all of its cases). --rows keeps the
rows of finished cases until all are done: a run that was stopped goes on after the last of them (as long as command and cases are the
same). Exit status 1 if any row misses its target.
"""
import argparse
import dataclasses
import datetime
import hashlib
import importlib
import json
import re
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import harness    # noqa: E402

MODULES = ["added_mass_cases", "parts_cases", "gap_parts_cases", "space_parts_cases", "curved_parts_cases", "near_parts_cases", "ideal_step_cases", "ideal_motion_cases", "pressure_cases", "motion_cases", "contact_cases", "viscous_cases", "viscous_flow_cases", "viscous_body_cases", "driven_cases", "film_cases", "far_cases", "graded_cases", "follow_cases", "unit_cases", "robustness_cases", "random_scenes"]


def chosen_cases(names, only):
    """[(module, case function)], those named in `only` (None: all)."""
    cases = [(module, case) for module in map(importlib.import_module, names) for case in module.ALL]
    if only is None:
        return cases
    known = {case.__name__ for _, case in cases}
    if unknown := set(only) - known:
        sys.exit(f"no case {', '.join(sorted(unknown))}; there are {', '.join(sorted(known))}")
    return [(module, case) for module, case in cases if case.__name__ in only]


def rows_of(case, quick):
    """Rows of one case; one that raises ends with a failed row and does not stop the others."""
    try:
        yield from case(quick)
    except Exception as error:    # noqa: BLE001
        yield harness.Row("Cases that did not run", case.__name__, "runs", f"{type(error).__name__}: {str(error)[-300:]}".replace("\n", " "), False)


class KeptRows:
    """Rows and seconds of finished cases in a file, by the case's name and what it depends on."""

    def __init__(self, file, quick):
        self.file, self.marks = file, (" quick" if quick else "") + (f" on {harness.MODEL}" if harness.MODEL else "")
        self.kept = json.loads(file.read_text()) if file and file.exists() else {}
        self.command = Path(harness.COMMAND).read_bytes()

    def key(self, module, case):
        digest = hashlib.sha256(self.command + Path(module.__file__).read_bytes() + Path(harness.__file__).read_bytes()).hexdigest()[:16]
        return f"{module.__name__}.{case.__name__}{self.marks} {digest}"

    def get(self, module, case):
        found = self.kept.get(self.key(module, case))
        return ([harness.Row(**row) for row in found["rows"]], found["seconds"]) if found else None

    def put(self, module, case, rows, seconds):
        self.kept[self.key(module, case)] = {"rows": [dataclasses.asdict(row) for row in rows], "seconds": seconds}
        if self.file:
            self.file.parent.mkdir(parents=True, exist_ok=True)
            partial = self.file.with_suffix(".part")
            partial.write_text(json.dumps(self.kept, indent=1))
            partial.replace(self.file)

    def done(self):
        if self.file:
            self.file.unlink(missing_ok=True)


def section_lines(section, rows):
    lines = [f"## {section}", ""]
    if section in harness.PICTURES:
        lines += [harness.PICTURES[section], ""]
    lines += ["| case | target | measured | |", "|---|---|---|---|"]
    for row in rows:
        if row.section == section:
            mark = ("met" if row.ok else "**MISSED**") if row.target else "reported"
            lines.append("| " + " | ".join(text.replace("|", "\\|") for text in (row.case, row.target, row.measured, mark)) + " |")
    return lines + [""]


def with_sections(text, rows):
    """The Markdown of an earlier run with the rows' sections in place of its own of these names; new ones at its end. The head keeps its words, its counts are made anew."""
    head, *old = re.split(r"^(?=## )", text, flags=re.MULTILINE)
    parts = {part.split("\n", 1)[0].removeprefix("## "): part for part in old}
    for section in dict.fromkeys(row.section for row in rows):
        parts[section] = "\n".join(section_lines(section, rows)) + "\n"
    body = "".join(part.rstrip("\n") + "\n\n" for part in parts.values()).rstrip("\n") + "\n"
    marks = re.findall(r"\| (met|\*\*missed\*\*|reported) \|$", (head + body).replace("MISSED", "missed"), flags=re.MULTILINE)
    head = re.sub(r"\d+ rows, \*\*\d+ miss their target\*\*", f"{len(marks)} rows, **{marks.count('**missed**')} miss their target**", head)
    return head + body


def markdown(rows, version, seconds):
    failed = sum(not row.ok for row in rows)
    lines = ["# Validation", "", f"Written by `tools/validate`: {version}, {datetime.date.today().isoformat()}, {seconds / 60:.0f} minutes; {len(rows)} rows, "
             + (f"**{failed} miss their target**." if failed else "all meet their targets."),
             "Exact data: `tests/data/reference`. Ranges are lowest … highest error over the placements named.", ""]
    for section in dict.fromkeys(row.section for row in rows):
        lines += section_lines(section, rows)
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true", help="the subset that every change must pass")
    parser.add_argument("--write", metavar="FILE", type=Path, help="Markdown table")
    parser.add_argument("--into", metavar="FILE", type=Path, help="Markdown table of an earlier run, whose sections are replaced")
    parser.add_argument("--rows", metavar="FILE", type=Path, help="keeps the rows of finished cases of a run that is stopped")
    parser.add_argument("--only", metavar="CASE,...", help="names of case functions of the modules")
    parser.add_argument("--model", choices=["parts"], help="gap.model of the scenes that name none, in place of the program's default")
    parser.add_argument("module", nargs="*", choices=[[], *MODULES], help=", ".join(MODULES))
    options = parser.parse_args()
    harness.MODEL = options.model
    cases = chosen_cases(options.module or MODULES, options.only.split(",") if options.only else None)
    if target := options.write or options.into:
        harness.PICTURE_FOLDER = target.parent / "images"
        harness.PICTURE_FOLDER.mkdir(parents=True, exist_ok=True)

    version = harness.command(["--version"]).stdout.strip()
    kept = KeptRows(options.rows, options.quick)
    rows, section, seconds = [], None, 0.0
    for number, (module, case) in enumerate(cases, start=1):
        start, known, own = time.time(), kept.get(module, case), []
        for row in known[0] if known else rows_of(case, options.quick):
            if row.section != section:
                section = row.section
                print(f"\n{section}", flush=True)
            own.append(row)
            mark = "ok  " if row.ok else "MISS"
            print(f"  {mark} {row.case}: {row.measured}" + (f"  [{row.target}]" if row.target else ""), flush=True)
        taken = known[1] if known else time.time() - start
        if not known:
            kept.put(module, case, own, taken)
        rows += own
        seconds += taken
        print(f"  ---- {number} of {len(cases)} cases, {case.__name__} took {taken:.0f} s{' in an earlier run' if known else ''}, all so far {seconds:.0f} s", flush=True)
    failed = [row for row in rows if not row.ok]
    print(f"\n{len(rows)} rows, {len(failed)} missed, {seconds:.0f} s")
    for row in failed:
        print(f"  MISS {row.section}: {row.case}: {row.measured}  [{row.target}]")
    if options.write:
        options.write.parent.mkdir(parents=True, exist_ok=True)
        options.write.write_text(markdown(rows, version, seconds))
    if options.into:
        options.into.write_text(with_sections(options.into.read_text(), rows))
    kept.done()
    if not rows:
        print("no rows", file=sys.stderr)
    return 1 if failed or not rows else 0


if __name__ == "__main__":
    sys.exit(main())
