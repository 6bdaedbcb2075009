"""Runs the multiplayer demo and prints its bandwidth and errors.

Usage: tools/demo [OPTION]...

A server simulates cubes; clients on this machine show them. Twice the same
scene: poses sent as quantized motors, and by MultiplayerSynchronizer at 20 Hz.
Options: --cubes N  --clients K  --seconds S  --scene cubes|push  --window  --picture FILE
         --loss PERCENT  --burst PACKETS  --delay MS  --jitter MS  --reorder PERCENT
         --duplicate PERCENT  --rate BYTES  --json FILE  --engine COMMAND
"""

import argparse
import contextlib
import json
import os
import platform
import shlex
import signal
import sys
import tempfile

import checkout
import demo_network
import display
import project
from demo_measure import CUBES, METHODS, SPARE_SECONDS, run_arm
from demo_run import DemoRun, RunFailed, progress
from demo_table import json_rows, print_table



def parse_arguments(arguments):
    parser = argparse.ArgumentParser(
        prog="tools/demo", formatter_class=argparse.RawDescriptionHelpFormatter,
        description="A server simulates cubes, and clients on this machine show them. Runs the same scene twice:\n"
                    "with quantized motors, and with MultiplayerSynchronizer at 20 Hz. Prints one table.")
    parser.add_argument("--cubes", type=within(1, 2000), help="number of cubes (250; 901 in the scene push)")
    parser.add_argument("--clients", type=within(1, 6), default=2, help="number of clients (2)")
    parser.add_argument("--seconds", type=within(0, 3600), default=8,
                        help="length of each run (8); 0: play in windows until they are closed, without a table")
    parser.add_argument("--scene", choices=("cubes", "push"), default="cubes",
                        help="cubes: structures that fall; push: a field of cubes that a ball plows through")
    parser.add_argument("--window", action="store_true", help="open a window for each client")
    parser.add_argument("--picture", metavar="FILE",
                        help="only save a screenshot of the first client in the middle of the scene")
    parser.add_argument("--json", metavar="FILE", help="write the figures to FILE")
    parser.add_argument("--engine", metavar="COMMAND", help="the Godot command to use (default: the engine of tools/setup)")
    demo_network.add_arguments(parser, within)
    return parser.parse_args(arguments)


def within(least, most):
    def number(text):
        value = int(text)
        if not least <= value <= most:
            raise argparse.ArgumentTypeError(f"{value} is not from {least} to {most}")
        return value
    number.__name__ = "number"
    return number


def main():
    options = parse_arguments(sys.argv[1:])
    if options.cubes is None:
        options.cubes = CUBES[options.scene]
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    try:
        engine = shlex.split(options.engine) if options.engine else [checkout.ENGINE]
        if options.engine:
            os.makedirs(os.path.join(checkout.PROJECT, ".godot"), exist_ok=True)
            project.list_extensions(checkout.PROJECT)
        else:
            project.prepare(checkout.PROJECT)
        with tempfile.TemporaryDirectory(prefix="ga_godot_demo_") as folder:
            if options.picture:
                take_picture(engine, folder, options)
            elif options.seconds == 0:
                play(engine, folder, options)
            else:
                measure(engine, folder, options)
    except RunFailed as failure:
        progress("")
        print(f"demo: {failure}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130
    return 0


def measure(engine, folder, options):
    """Runs both methods in turn and prints the table."""
    if options.window:
        need_display()
    arms = {}
    for method in METHODS:
        arm_folder = os.path.join(folder, method)
        os.mkdir(arm_folder)
        arms[method] = run_arm(engine, arm_folder, options, method)
    progress("")
    print_table(arms, options)
    if options.json:
        with open(options.json, "w", encoding="utf-8") as file:
            json.dump({"rows": json_rows(arms, options), "machine": machine()}, file, indent=1)
            file.write("\n")


def play(engine, folder, options):
    """Opens windows to play in, until the last is closed."""
    need_display()
    with DemoRun(engine, folder) as run:
        run.start_server(f"--scene={options.scene}", f"--cubes={options.cubes}", "--quit-when-empty=on", "--record=")
        for number in range(options.clients):
            run.start_client(*demo_network.client_arguments(options, number + 1), "--record=", window=number)
        run.wait(float("inf"))


def take_picture(engine, folder, options):
    """Saves a screenshot of a client, with a second player driving around; uses Xvfb if there is no display."""
    path = os.path.abspath(options.picture)
    with contextlib.ExitStack() as stack:
        if not os.environ.get("DISPLAY"):
            os.environ.update(stack.enter_context(display.display()))
        run = stack.enter_context(DemoRun(engine, folder))
        run.start_server(f"--scene={options.scene}", f"--cubes={options.cubes}", "--clients=2", "--record=")
        run.start_client("--name=Bea", "--autopilot=circle", "--record=")
        first = run.start_client("--name=Ada", f"--picture={path}", f"--picture-after={options.seconds}",
                                 "--record=", window=0)
        first.process.wait(timeout=options.seconds + SPARE_SECONDS)
        first.check_log()
    if not os.path.isfile(path):
        raise RunFailed(f"no screenshot was saved: {first.last_words()}")
    print(f"demo: saved {options.picture}")


def need_display():
    if sys.platform.startswith("linux") and not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        raise RunFailed("windows need a display, and DISPLAY is not set: set it, or remove --window")


def machine():
    return f"{platform.system()} {platform.machine()}, {os.cpu_count()} cores"


if __name__ == "__main__":
    sys.exit(main())
