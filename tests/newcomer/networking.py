"""The networking guide: two processes of its project, one with the arguments "-- host", and what the client shows."""

import math
import os
import subprocess
import time

import checkout
import engine_log
from demo_run import free_port
from pose_error import percentile

SECONDS = 5.0
RADIUS = 2.0
FILES = ("main.gd", "main.tscn")
# An autoload that prints the cube's position with the system clock, and quits, where the variable is set.
PROBE = """extends Node

var seconds := OS.get_environment("NEWCOMER_SECONDS").to_float()


func _process(_delta: float) -> void:
	if seconds == 0.0:
		return
	var cube: Node3D = get_node_or_null(^"/root/Main/Cube")
	if cube != null:
		print("PROBE %.4f %.5f %.5f" % [Time.get_unix_time_from_system(), cube.position.x, cube.position.z])
	if Time.get_ticks_msec() > seconds * 1000.0:
		get_tree().quit()
"""


def prepare(newcomer):
    """Writes the files of the guide. The scene is the one that the steps gave (guides.py), else that of the page."""
    if newcomer.port:
        return
    newcomer.port = free_port()
    samples = {sample.name: sample.text for sample in newcomer.page("docs/guides/networking.md")}
    for name in FILES:
        if not os.path.exists(newcomer.path(name)):
            newcomer.write(name, samples[name])
    script = samples["main.gd"]
    assert script.count("const PORT := 24900") == 1, "the guide's main.gd does not contain 'const PORT := 24900' exactly once"
    newcomer.write("main.gd", script.replace("24900", str(newcomer.port)))
    newcomer.write("probe.gd", PROBE)
    # F5 asks for the main scene.
    newcomer.write("project.godot", newcomer.read("project.godot").replace(
        "[application]\n", '[application]\n\nrun/main_scene="res://main.tscn"', 1))
    newcomer.set("autoload", "Probe", '"*res://probe.gd"')


def networking_guide(newcomer):
    prepare(newcomer)
    check_motion(newcomer, [checkout.ENGINE, "--headless", "--path", newcomer.project], newcomer.project)


def check_motion(newcomer, command, folder):
    """Runs a host and a client in a folder: the client shows the cube on its circle, smoothly."""
    host = start(newcomer, [*command, "--", "host"], folder, "host")
    time.sleep(1.0)
    client = start(newcomer, command, folder, "client")
    truth, shown = samples_of(host), samples_of(client)
    moving = [sample for sample in shown if abs(math.hypot(sample[1], sample[2]) - RADIUS) < 0.5]
    assert len(moving) >= 60, f"the client showed the cube in motion in only {len(moving)} frames"
    settled = [sample for sample in moving[len(moving) // 4:] if sample[0] < truth[-1][0]]
    deviation = max(abs(math.hypot(x, z) - RADIUS) for _, x, z in settled)
    assert deviation <= 0.006, f"the client's cube deviates from its circle by {deviation * 1000:.1f} mm"
    delays = [delay(truth, sample) for sample in settled]
    delays = [value for value in delays if value is not None]
    assert len(delays) >= 30, "host and client ran at the same time for too short"
    median = percentile(delays, 0.5)
    assert 0.05 < median < 0.25, f"the client is {median * 1000:.0f} ms behind"
    spread = percentile(delays, 0.95) - percentile(delays, 0.05)
    assert spread <= 0.08, f"the client's delay varies by {spread * 1000:.0f} ms"
    print(f"   {deviation * 1000:.1f} mm from the circle, {median * 1000:.0f} ms behind the host", flush=True)


def start(newcomer, command, folder, name):
    log = open(os.path.join(newcomer.place, name + ".log"), "w", encoding="utf-8")  # noqa: SIM115
    environment = {**newcomer.environment, "NEWCOMER_SECONDS": str(SECONDS)}
    process = subprocess.Popen(command, cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=log, stderr=subprocess.STDOUT)
    return process, log.name


def samples_of(started):
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
    assert not problems and process.returncode == 0, f"exit code {process.returncode}; {problems}"
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


CASES = (networking_guide,)
