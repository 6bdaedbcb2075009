"""The exported games: what is in them, and whether they run."""

import os
import re
import shlex
import subprocess
import tempfile

import checkout
import engine_log
import libraries
import projects
from checks import expect, expect_good_network_errors, server_record
from demo_run import DemoRun
from exporter import export, run_export
from pose_error import rows_at
from pose_record import PoseRecord, ROW_FLOATS, lever_distance

GUIDE = os.path.join(checkout.ROOT, "docs", "guides", "exporting.md")
CUBES = 80
SECONDS = 4
RUN_SECONDS = 60
PROBED = ["entries A", "words point, at (0, 0, 0)", "example Circle through three points", "done"]
# Bytes that are compared of a signed library, from its first quarter on, which is code: the signature changes other parts.
SAMPLE = 50_000
LIBRARY_SUFFIXES = (".so", ".dll", ".dylib")
ADDON = "addons/ga_godot/"
PLAYGROUND = ("addons/ga_godot/playground/", "addons/ga_godot/gallery/")
# What is for the editor or for reading.
NOT_FOR_GAMES = ("addons/ga_godot/docs/", "addons/ga_godot/editor/", "addons/ga_godot/plugin", "addons/ga_godot/bin/", "tests/")
NAMES = {"linux": "game.bin", "windows": "game.exe", "macos": "game.app"}


class Games:
    """The exports, each made when it is first asked for."""

    def __init__(self, folder, templates):
        self.folder = folder
        self.demos = projects.make_demos(folder, templates)
        self.game = projects.make_game(folder, templates)
        self._made = {}

    def demo(self, preset, kind):
        """The demos, exported by a preset in a kind, debug or release."""
        system = projects.SYSTEMS.get(preset, ("linux",))[0]
        key = f"{preset}_{kind}".replace(" ", "_")
        if key not in self._made:
            self._made[key] = export(self.demos, preset, kind, os.path.join(self.folder, key), NAMES[system])
        return self._made[key]

    def small_game(self):
        """The project that contains only the addon, exported for this machine by the command in the guide."""
        folder = os.path.join(self.game, "build")
        os.makedirs(folder)
        with open(GUIDE, encoding="utf-8") as page:
            command = re.search(r"^godot --headless --path \. (--export-\S+ .*)$", page.read(), re.M)[1]
        arguments = shlex.split(command)
        return run_export(self.game, folder, os.path.basename(arguments[-1]), arguments)


def check_library(games, preset, kind):
    """The export has the library that the addon lists for the system, unchanged, and no other."""
    system, arch = projects.SYSTEMS[preset]
    exported = games.demo(preset, kind)
    wanted = libraries.expected(games.demos, (system, arch, kind))
    expect(f".{system}.{arch}." in os.path.basename(wanted), f"the addon lists {os.path.basename(wanted)} for {system}, {arch}")
    place = os.path.join(NAMES[system], "Contents", "Frameworks") if system == "macos" else ""
    found = exported.libraries()
    expect(list(found) == [os.path.join(place, os.path.basename(wanted))],
           f"the export has the libraries {sorted(found)}, but the addon lists {os.path.basename(wanted)}")
    original, copy = read(wanted), read(*found.values())
    seals = [path for name, path in exported.files.items() if name.endswith("CodeResources")]
    if seals:
        # Godot has signed the application and the library in it.
        expect(f"Frameworks/{os.path.basename(wanted)}".encode() in read(seals[0]), "the signature does not cover the library")
        expect(original[len(original) // 4:][:SAMPLE] in copy, f"{os.path.basename(wanted)} has other code in the export")
    else:
        expect(original == copy, f"{os.path.basename(wanted)} was changed by the export")
    check_pack(exported)


def check_pack(exported):
    """The pack names the extension and has nothing that only the editor or a reader needs."""
    expect(ADDON + "ga_godot.gdextension" in exported.packed, "the pack has no ga_godot.gdextension")
    listed = exported.packed[".godot/extension_list.cfg"].decode().split()
    expect(listed == ["res://addons/ga_godot/ga_godot.gdextension"], f"the pack lists the extensions {listed}")
    excess = [name for name in exported.packed if name.startswith(NOT_FOR_GAMES) or name.endswith((*LIBRARY_SUFFIXES, ".md"))]
    expect(not excess, f"the pack has {len(excess)} files too many: {excess[:5]}")


def demos_contain_the_playground_that_they_use(games):
    exported = games.demo(projects.host_preset(), "debug")
    for folder in PLAYGROUND:
        expect(any(name.startswith(folder) for name in exported.packed), f"the pack has nothing of {folder}")


def playground_works_in_the_exported_demos(games):
    text = run(games.demo(projects.host_preset(), "debug"), "--", "--probe")
    printed = re.findall(r"^\[probe\] (.*)$", text, re.MULTILINE)
    expect(printed == PROBED, f"the probe printed {printed}, expected {PROBED}")


def game_that_does_not_use_the_playground_does_not_contain_it(games):
    exported = games.small_game()
    excess = [name for name in exported.packed if name.startswith(PLAYGROUND)]
    expect(not excess, f"the pack has {len(excess)} files of the playground: {excess[:5]}")
    check_pack(exported)
    # The main scene is an example of the addon: a server and a client in one program.
    run(exported, "--quit-after", "120")


def run(exported, *arguments):
    """Runs an exported game without a window; returns its output."""
    try:
        done = subprocess.run([exported.executable, "--headless", *arguments], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, timeout=RUN_SECONDS, text=True, errors="replace", check=False)
    except subprocess.TimeoutExpired as stopped:
        printed = (stopped.stdout or b"").decode(errors="replace")
        raise AssertionError(f"the game did not quit within {RUN_SECONDS} s:\n{printed[-2000:]}") from None
    problems = engine_log.problems_of(done.stdout)
    expect(done.returncode == 0 and not problems, f"the game ended with exit code {done.returncode}: {problems}\n{done.stdout}")
    return done.stdout


def debug_server_and_two_clients_show_the_motion(games):
    program = games.demo(projects.host_preset(), "debug").executable
    check_session({"server": [program, "--headless"], "client": [program, "--headless"]})


def dedicated_server_and_two_release_clients_show_the_motion(games):
    """A dedicated server runs without --headless, and without a display."""
    server = games.demo(projects.SERVER, "release").executable
    client = games.demo(projects.host_preset(), "release").executable
    check_session({"server": ["env", "-u", "DISPLAY", "-u", "WAYLAND_DISPLAY", server], "client": [client, "--headless"]})


def check_session(programs):
    """A server and two clients over ENet: the clients show the server's motion and all end without an error."""
    exported = {role: [*command, "--", "--demo=multiplayer"] for role, command in programs.items()}
    with tempfile.TemporaryDirectory(prefix="ga_godot_exported_") as folder, DemoRun(None, folder, exported) as session:
        session.start_server(f"--cubes={CUBES}", f"--seconds={SECONDS}", "--clients=2")
        session.start_client()
        session.start_client("--autopilot=circle")
        session.wait(RUN_SECONDS)
        session.check_logs()
        for process in (session.server, *session.clients):
            expect(process.process.returncode == 0, f"{process.name} ended with exit code {process.process.returncode}")
        for client in session.clients:
            samples = expect_good_network_errors(session, client, CUBES)
            shown, truth = displacements(session, client)
            print(f"{client.name}: {samples} samples of moving cubes; the farthest moved {truth:.2f} m, shown as {shown:.2f} m")
            expect(truth > 1.0 and abs(shown - truth) < 0.02,
                   f"{client.name} showed {shown:.3f} m of motion instead of {truth:.3f} m")
            expect(client.report()["rejected"] == 0, f"{client.name} rejected packets")


def displacements(session, client):
    """How far the client showed the cube moving that moved farthest, and how far the server moved it, in meters."""
    server, _, _ = server_record(session, CUBES)
    shown = PoseRecord(client.record_path, CUBES)
    pairs = [(rows, rows_at(server, server.ticks, tick)[0]) for rows, tick in zip(shown.rows, shown.ticks)]
    pairs = [pair for pair in pairs if pair[1] is not None]
    moved = [[lever_distance(pairs[0][side], pairs[-1][side], at) for side in (0, 1)]
             for at in range(0, CUBES * ROW_FLOATS, ROW_FLOATS)]
    return max(moved, key=lambda distances: distances[1])


def read(path):
    with open(path, "rb") as file:
        return file.read()


def library_case(preset, kind):
    """The case of one preset and kind."""
    def case(games):
        check_library(games, preset, kind)
    case.__name__ = f"{preset.replace(' ', '_').lower()}_{kind}_contains_its_library_only"
    return case


CASES = (
    *(library_case(preset, kind) for preset in projects.SYSTEMS for kind in ("debug", "release")),
    demos_contain_the_playground_that_they_use,
    playground_works_in_the_exported_demos,
    game_that_does_not_use_the_playground_does_not_contain_it,
    debug_server_and_two_clients_show_the_motion,
    dedicated_server_and_two_release_clients_show_the_motion,
)
