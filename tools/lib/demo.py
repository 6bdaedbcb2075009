"""Runs the multiplayer demo and prints its cost and error.

Usage: tools/demo [OPTION]...

A server simulates cubes, and clients on this machine show them. The scene is run
twice: replicated by MotorSynchronizer, and by MultiplayerSynchronizer at 20 Hz.
In the scene avatars each client owns an avatar; it is run with and without relay.
Options: --scene cubes|push|avatars  --cubes N  --clients K  --seconds S  --window
         --picture FILE  --relay on|off
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
import demo_avatars
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
                    "by MotorSynchronizer, and by MultiplayerSynchronizer at 20 Hz. In the scene avatars each client owns a head\n"
                    "and two hands; the scene is run with MotorSynchronizer's relay, and with Godot's forwarding. Prints one table.")
    parser.add_argument("--cubes", type=within(1, 2000), help="number of cubes (250; 901 in the scene push)")
    parser.add_argument("--clients", type=within(1, 16),
                        help="number of clients, at most 6 (2); in the scene avatars, 2 to 16 (8)")
    parser.add_argument("--seconds", type=within(0, 3600), default=8,
                        help="duration of each run (8); 0: play in windows until they are closed, without a table")
    parser.add_argument("--scene", choices=("cubes", "push", demo_avatars.SCENE), default="cubes",
                        help="cubes: collapsing structures; push: a ball plows through a field of cubes; "
                             "avatars: each client owns a head and two hands (cubes)")
    parser.add_argument("--relay", choices=demo_avatars.ARMS,
                        help="avatars: whether MotorSynchronizer's relay or Godot forwards the motion of the clients (on); "
                             "a measurement without this option runs both")
    parser.add_argument("--window", action="store_true",
                        help="show the clients in windows; in the scene avatars, the first one")
    parser.add_argument("--picture", metavar="FILE",
                        help="save a screenshot of the first client in the middle of the scene instead of measuring")
    parser.add_argument("--json", metavar="FILE", help="write the results to FILE")
    parser.add_argument("--engine", metavar="COMMAND", help="command that starts Godot (the one that tools/setup provides)")
    demo_network.add_arguments(parser, within)
    options = parser.parse_args(arguments)
    avatars = options.scene == demo_avatars.SCENE
    options.clients = options.clients or (8 if avatars else 2)
    if avatars and (options.cubes is not None or options.clients < 2):
        parser.error("the scene avatars has no cubes and at least 2 clients: omit --cubes, and use --clients 2 to 16")
    if not avatars and (options.relay or options.clients > 6):
        parser.error(f"the scene {options.scene} has at most 6 clients and no relay: use --clients 1 to 6, and omit --relay")
    if options.cubes is None:
        options.cubes = CUBES.get(options.scene)
    return options


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
    """Runs the scene in both variants, one after the other, and prints the table."""
    if options.window:
        need_display()
    if options.scene == demo_avatars.SCENE:
        rows = measure_avatars(engine, folder, options)
    else:
        rows = measure_methods(engine, folder, options)
    if options.json:
        with open(options.json, "w", encoding="utf-8") as file:
            json.dump({"rows": rows, "machine": machine()}, file, indent=1)
            file.write("\n")


def measure_methods(engine, folder, options):
    arms = {}
    for method in METHODS:
        arm_folder = os.path.join(folder, method)
        os.mkdir(arm_folder)
        arms[method] = run_arm(engine, arm_folder, options, method)
    progress("")
    print_table(arms, options)
    return json_rows(arms, options)


def measure_avatars(engine, folder, options):
    arms = {}
    for relay in [options.relay] if options.relay else demo_avatars.ARMS:
        arm_folder = os.path.join(folder, relay)
        os.mkdir(arm_folder)
        arms[relay] = demo_avatars.run_avatars(engine, arm_folder, options, relay)
    progress("")
    demo_avatars.print_table(arms, options)
    return demo_avatars.json_rows(arms, options)


def play(engine, folder, options):
    """Opens windows to play in; returns when the last is closed."""
    need_display()
    with DemoRun(engine, folder) as run:
        if options.scene == demo_avatars.SCENE:
            options.window = True
            run.start_server("--scene=avatars", f"--relay={options.relay or 'on'}", "--quit-when-empty=on", "--record=")
            demo_avatars.start_clients(run, options, 0)
            # The others have no window.
            run.clients[0].process.wait()
            return
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
        if options.scene == demo_avatars.SCENE:
            run.start_server("--scene=avatars", f"--relay={options.relay or 'on'}", "--record=")
            for _ in range(options.clients - 1):
                run.start_client("--scene=avatars", "--record=")
        else:
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
