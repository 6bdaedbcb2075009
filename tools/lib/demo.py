"""Runs the multiplayer demo and prints its cost and error.

Usage: tools/demo [OPTION]...

A server simulates cubes, and clients on this machine show them. The scene is run
twice: replicated by MotorSynchronizer, and by MultiplayerSynchronizer at 20 Hz.
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
        description="A server simulates cubes, and clients on this machine show them. The scene is run twice: replicated\n"
                    "by MotorSynchronizer, and by MultiplayerSynchronizer at 20 Hz. Prints one table.")
    parser.add_argument("--cubes", type=within(1, 2000), help="number of cubes (250; 901 in the scene push)")
    parser.add_argument("--clients", type=within(1, 6), default=2, help="number of clients (2)")
    parser.add_argument("--seconds", type=within(0, 3600), default=8,
                        help="duration of each run (8); 0: play in windows until they are closed, without a table")
    parser.add_argument("--scene", choices=("cubes", "push"), default="cubes",
                        help="cubes: collapsing structures; push: a ball plows through a field of cubes (cubes)")
    parser.add_argument("--window", action="store_true", help="show the clients in windows")
    parser.add_argument("--picture", metavar="FILE",
                        help="save a screenshot of the first client in the middle of the scene instead of measuring")
    parser.add_argument("--json", metavar="FILE", help="write the results to FILE")
    parser.add_argument("--engine", metavar="COMMAND", help="command that starts Godot (the one that tools/setup provides)")
    demo_network.add_arguments(parser, within)
    return parser.parse_args(arguments)


def within(minimum, maximum):
    """An argparse type: an integer from `minimum` to `maximum`."""
    def number(text):
        value = int(text)
        if not minimum <= value <= maximum:
            raise argparse.ArgumentTypeError(f"{value} is not in the range from {minimum} to {maximum}")
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
                take_screenshot(engine, folder, options)
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
    """Runs the scene with both methods, one after the other, and prints the table."""
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
    """Opens windows to play in; returns when the last is closed."""
    need_display()
    with DemoRun(engine, folder) as run:
        run.start_server(f"--scene={options.scene}", f"--cubes={options.cubes}", "--quit-when-empty=on", "--record=")
        for number in range(options.clients):
            run.start_client(*demo_network.client_arguments(options, number + 1), "--record=", window=number)
        run.wait(float("inf"))


def take_screenshot(engine, folder, options):
    """Saves what a client's window shows while a second player drives in circles; starts a virtual display if necessary."""
    path = os.path.abspath(options.picture)
    with contextlib.ExitStack() as stack:
        if not os.environ.get("DISPLAY"):
            os.environ.update(stack.enter_context(display.display()))
        run = stack.enter_context(DemoRun(engine, folder))
        run.start_server(f"--scene={options.scene}", f"--cubes={options.cubes}", "--clients=2", "--record=")
        run.start_client("--name=Bea", "--autopilot=circle", "--record=")
        first = run.start_client("--name=Ada", f"--screenshot={path}", f"--screenshot-after={options.seconds}",
                                 "--record=", window=0)
        first.process.wait(timeout=options.seconds + SPARE_SECONDS)
        first.check_log()
    if not os.path.isfile(path):
        raise RunFailed(f"the client saved no screenshot; its last line of output: {first.last_line()}")
    print(f"demo: saved the screenshot to {options.picture}")


def need_display():
    if sys.platform.startswith("linux") and not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        raise RunFailed("windows need a display, but DISPLAY is not set; omit --window to run without windows")


def machine():
    return f"{platform.system()} {platform.machine()}, {os.cpu_count()} cores"


if __name__ == "__main__":
    sys.exit(main())
