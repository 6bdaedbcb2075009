"""Follows docs/guides/networking.md in a new project and checks what a client shows."""

import math
import os
import re
import shutil
import subprocess
import time

import checkout
import engine_log
from pose_error import percentile

PAGE = os.path.join(checkout.ROOT, "docs", "guides", "networking.md")
FILE = re.compile(r"^```(?:tscn|gdscript) (\S+)\n(.*?)^```$", re.M | re.S)
SECONDS = 5.0
RADIUS = 2.0
# Autoload added to the guide's project: prints the cube's position with the system clock, then quits.
PROBE = """extends Node


func _process(_delta: float) -> void:
	var cube: Node3D = get_node_or_null(^"/root/Main/Cube")
	if cube != null:
		print("PROBE %.4f %.5f %.5f" % [Time.get_unix_time_from_system(), cube.position.x, cube.position.z])
	if Time.get_ticks_msec() > SECONDS * 1000.0:
		get_tree().quit()
"""
PROJECT = """config_version=5

[application]
config/name="Guide"
run/main_scene="res://main.tscn"

[autoload]
Probe="*res://probe.gd"
"""


def guide_project_moves_smoothly(run):
    folder = make_project(run.folder)
    port = str(run.port)
    with open(os.path.join(folder, "main.gd"), encoding="utf-8") as file:
        script = file.read()
    if script.count("const PORT := 24900") != 1:
        raise AssertionError("the guide's main.gd does not contain 'const PORT := 24900' exactly once")
    with open(os.path.join(folder, "main.gd"), "w", encoding="utf-8") as file:
        file.write(script.replace("24900", port))
    host = start(run.engine, folder, "host", "host")
    time.sleep(1.0)
    client = start(run.engine, folder, "client", "join")
    truth, shown = samples(host), samples(client)
    moving = [sample for sample in shown if abs(math.hypot(sample[1], sample[2]) - RADIUS) < 0.5]
    if len(moving) < 60:
        raise AssertionError(f"the client showed the cube in motion in only {len(moving)} frames")
    settled = [sample for sample in moving[len(moving) // 4:] if sample[0] < truth[-1][0]]
    deviation = max(abs(math.hypot(x, z) - RADIUS) for _, x, z in settled)
    if deviation > 0.006:
        raise AssertionError(f"the client's cube deviates from its circle by {deviation * 1000:.1f} mm")
    delays = [delay(truth, sample) for sample in settled]
    delays = [value for value in delays if value is not None]
    if len(delays) < 30:
        raise AssertionError("host and client ran at the same time for too short")
    median = percentile(delays, 0.5)
    if not 0.05 < median < 0.25:
        raise AssertionError(f"the client is {median * 1000:.0f} ms behind")
    spread = percentile(delays, 0.95) - percentile(delays, 0.05)
    if spread > 0.08:
        raise AssertionError(f"the client's delay varies by {spread * 1000:.0f} ms")


def make_project(folder):
    """A new project with the addon and the files of the guide."""
    project = os.path.join(folder, "guide")
    os.makedirs(os.path.join(project, ".godot"))
    shutil.copytree(os.path.join(checkout.PROJECT, "addons"), os.path.join(project, "addons"))
    with open(PAGE, encoding="utf-8") as page:
        files = dict(FILE.findall(page.read()))
    # The scripts of situations belong to other scenes (godot_project/tests/test_networking_guide.gd).
    files = {name: text for name, text in files.items() if name.startswith("main.")}
    if sorted(files) != ["main.gd", "main.tscn"]:
        raise AssertionError(f"the guide has the files {sorted(files)} instead of main.gd and main.tscn")
    files["probe.gd"] = PROBE.replace("SECONDS", str(SECONDS))
    files["project.godot"] = PROJECT
    files[".godot/extension_list.cfg"] = "res://addons/ga_godot/ga_godot.gdextension\n"
    for name, text in files.items():
        with open(os.path.join(project, name), "w", encoding="utf-8") as file:
            file.write(text)
    return project


def start(engine, folder, name, argument):
    log = open(os.path.join(folder, name + ".log"), "w", encoding="utf-8")  # noqa: SIM115
    command = [*engine, "--headless", "--path", folder, "--", argument]
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=log, stderr=subprocess.STDOUT)
    return process, log.name


def samples(started):
    """Waits for a process; returns what its probe printed: (clock, x, z)."""
    process, path = started
    try:
        process.wait(timeout=40)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
        raise AssertionError("a process of the guide's project did not quit within 40 s") from None
    with open(path, encoding="utf-8", errors="replace") as file:
        text = file.read()
    problems = engine_log.problems_of(text)
    if problems or process.returncode != 0:
        raise AssertionError(f"exit code {process.returncode}; {problems}")
    return [tuple(map(float, line.split()[1:])) for line in text.splitlines() if line.startswith("PROBE ")]


def delay(truth, sample):
    """The age, in seconds, of the host's sample nearest to the client's position; None if none is within 5 cm."""
    clock, x, z = sample
    best = None
    for at, host_x, host_z in truth:
        if clock - 1.0 < at <= clock:
            distance = math.hypot(host_x - x, host_z - z)
            if best is None or distance < best[0]:
                best = (distance, clock - at)
    return best[1] if best is not None and best[0] < 0.05 else None
