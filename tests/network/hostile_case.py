"""What a hostile client can do: nothing to anybody, and little to the server's time."""

import os
import re
import time

from checks import expect, expect_errors_within, processor_seconds
from demo_run import START_SECONDS

SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "hostile_client.gd")
BAD_PACKETS = 12000
CUBES = 250
SECONDS = 9
# The part of the scene in which the server's processor time is taken.
FROM, TO = 3.0, 8.0
FRAME = 1.0 / 60.0


def hostile_client_changes_nothing(run):
    calm, _ = play(run, 0)
    busy, sent = play(run, BAD_PACKETS)
    expect(sent > 0.7 * BAD_PACKETS * (SECONDS - 2), f"only {sent} bad packets in {SECONDS} s")
    rejected = run.server.report()["rejected"]
    expect(rejected > 0.5 * sent, f"of {sent} bad packets only {rejected} were counted as refused")
    for client in run.clients[:2]:
        expect_errors_within(run, client, CUBES, share=0.9, most=1.0)
        expect(client.report()["rejected"] == 0, f"{client.name} refused {client.report()['rejected']} packets")
    if calm is not None and busy is not None:
        print(f"   processor time of the server: {calm * FRAME * 1000:.2f} ms a frame of the 60 a second, "
              f"{busy * FRAME * 1000:.2f} with {sent / SECONDS:.0f} bad packets a second", flush=True)
        expect(busy - calm < 0.1, f"the server's frames take {(busy - calm) * FRAME * 1000:.1f} ms more, a tenth of a frame is allowed")


def play(run, bad_packets):
    """A session with two clients and a third that sends so many bad packets a second.

    Returns the server's processor time a second while the scene plays, and how many bad packets there were.
    """
    run.clients.clear()
    os.environ["GA_GODOT_BAD_PACKETS"] = str(bad_packets)
    run.start_server(f"--cubes={CUBES}", f"--seconds={SECONDS}", "--clients=3")
    run.start_client()
    run.start_client()
    third = run.start_client("--record=", script=SCRIPT)
    run.server.wait_for_line("The scene begins", START_SECONDS)
    begin = time.monotonic()
    time.sleep(FROM)
    before, since = processor_seconds(run.server.process), time.monotonic()
    time.sleep(max(0.0, begin + TO - time.monotonic()))
    after, until = processor_seconds(run.server.process), time.monotonic()
    run.wait(SECONDS + 40)
    run.check_logs()
    told = re.search(r"Sent (\d+) bad packets", third.log())
    used = None if before is None or after is None else (after - before) / (until - since)
    return used, int(told.group(1)) if told else 0


CASES = (hostile_client_changes_nothing,)
