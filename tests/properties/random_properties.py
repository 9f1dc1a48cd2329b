"""Properties that hold for every scene (properties.py), held against random ones; where one does not hold, the smallest scene that shows it.

    python3 random_properties.py run NUMBER|A-B... [--property NAME] [--steps N] [--jobs N] [--shrink SECONDS]
    python3 random_properties.py fresh COUNT ...              the same with scenes that nobody has seen
    python3 random_properties.py figures NUMBER|A-B...        what changed scenes are off by
    python3 random_properties.py check FILE.toml --property NAME
    python3 random_properties.py shrink FILE.toml|NUMBER --property NAME [--seconds N]
Scenes are those of tests/validation/random_scene_kinds.py: below 300 in 2D (also below 0), from 300 on in 3D. The command is that of GAPFLOW, or
the one in build/release.
"""
import argparse
import random
import re
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "validation"))
import harness    # noqa: E402
import random_scene_kinds as kinds    # noqa: E402
import scene_changes as changes    # noqa: E402
import shrink    # noqa: E402
from properties import PROPERTIES, Same, kind_of, sound    # noqa: E402

FLAT_STEPS, SOLID_STEPS = 20, 5
FOUND = Path("failing_scenes")    # in the current folder


def case_of(number, steps=None):
    with tempfile.TemporaryDirectory() as folder:
        case = changes.random_case(number, folder)
    steps = steps or (FLAT_STEPS if case.dimension == 2 else SOLID_STEPS)
    case.scene["time"]["end"] = steps * case.scene["time"]["max_step"]
    return case


def broken(case, name, prepared=False):
    """What of a scene breaks a property, as text; none if nothing does."""
    if not prepared:
        case = PROPERTIES[name].prepare(case)
    return PROPERTIES[name].broken(case) if case else None


def failures(number, names, steps=None):
    """[(property, text)] of a random scene."""
    case = case_of(number, steps)
    return [(name, text) for name in names for text in [broken(case, name)] if text]


def hand_out(case, name, label, seconds, folder=None):
    """Writes the smallest scene found that breaks a property as `case` does; returns what to tell of it."""
    folder = Path(folder or FOUND)
    kind = kind_of(PROPERTIES[name].broken(case))    # bodies that end elsewhere do not become velocities that start otherwise

    def fails(made):
        return sound(made, case) and kind_of(PROPERTIES[name].broken(made) or "") == kind

    small, done = shrink.smallest(case, fails, seconds)
    folder.mkdir(parents=True, exist_ok=True)
    why = PROPERTIES[name].broken(small)
    small.scene["title"] = f"breaks {name}: {why}"
    for k, body in enumerate(small.scene["body"]):    # meshes under names of their own
        if "file" in body:
            own = f"{label}_{name}_{body['file']}"
            small.files[own] = small.files[body["file"]]
            body["file"] = own
    file = small.write(folder, f"{label}_{name}").resolve()
    return (f"the smallest scene {'that breaks it' if done else f'found in {seconds:.0f} s'} ({shrink.described(small)}): {why}\n"
            f"  GAPFLOW={harness.COMMAND} python3 {Path(__file__).resolve()} check {file} --property {name}\n"
            f"  {harness.COMMAND} run {file}\n\n{harness.scene_text(small.scene)}")


# ---- command line

def numbers_of(words):
    for word in words:
        first, last = re.fullmatch(r"(-?\d+)(?:-(-?\d+))?", word).groups()
        yield from range(int(first), int(last or first) + 1)


def fresh(count):
    """Numbers of scenes beyond those of the validation; one in eight in 3D."""
    chance = random.SystemRandom()
    return [chance.randrange(10**6, 10**9) if k % 8 == 7 else -chance.randrange(1, 10**9) for k in range(count)]


def run_command(numbers, names, options):
    failed = 0
    with ThreadPoolExecutor(options.jobs) as pool:
        for number, found in zip(numbers, pool.map(lambda n: failures(n, names, options.steps), numbers)):
            kind = list(kinds.KINDS)[number % len(kinds.KINDS)]
            print(f"{number} {kind}: " + ("; ".join(f"{name}: {text}" for name, text in found) or "ok"), flush=True)
            failed += bool(found)
            for name, _ in found if options.shrink else []:
                print(hand_out(PROPERTIES[name].prepare(case_of(number, options.steps)), name, f"scene_{number}", options.shrink), flush=True)
    print(f"{len(numbers) - failed} of {len(numbers)} scenes break nothing")
    return 1 if failed else 0


def figures_command(numbers, names, options):
    def figures(number):
        case = case_of(number, options.steps)
        for name in names:
            made = PROPERTIES[name].prepare(case) if isinstance(PROPERTIES[name].broken, Same) else None
            if made:
                yield name, PROPERTIES[name].broken.figures(made)
    with ThreadPoolExecutor(options.jobs) as pool:
        for number, found in zip(numbers, pool.map(lambda n: list(figures(n)), numbers)):
            for name, what in found:
                print(number, name, what if what is None or isinstance(what, str) else "first {:.1e} last {:.1e} way {:.2g}".format(*what), flush=True)
    return 0


def one_command(options):
    if not options.property or len(options.property) != 1:
        sys.exit("say which property: --property NAME")
    name, what = options.property[0], options.what[0]
    is_number = re.fullmatch(r"-?\d+", what)
    case = PROPERTIES[name].prepare(case_of(int(what), options.steps)) if is_number else changes.read_case(what)
    text = PROPERTIES[name].broken(case) if case else None
    print(f"{name}: {text or 'holds'}")
    if text and options.command == "shrink":
        print(hand_out(case, name, f"scene_{what}" if is_number else Path(what).stem, options.seconds))
    return 1 if text else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", choices=["run", "fresh", "figures", "check", "shrink"])
    parser.add_argument("what", nargs="+", help="numbers of scenes, how many, or a file")
    parser.add_argument("--property", action="append", choices=list(PROPERTIES), help="only this one; as often as needed")
    parser.add_argument("--steps", type=int, help=f"full steps of a run; {FLAT_STEPS} in 2D, {SOLID_STEPS} in 3D")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--shrink", metavar="SECONDS", type=float, default=0.0, help="for the smallest scene of each failure")
    parser.add_argument("--seconds", type=float, default=300.0, help="for the smallest scene")
    options = parser.parse_args()
    names = options.property or list(PROPERTIES)
    if options.command in ("run", "figures"):
        return (run_command if options.command == "run" else figures_command)(list(numbers_of(options.what)), names, options)
    return run_command(fresh(int(options.what[0])), names, options) if options.command == "fresh" else one_command(options)


if __name__ == "__main__":
    sys.exit(main())
