"""2D, and faults of a scene that only show at run time."""

from pose_error import percentile
from situation_checks import Findings, truth_of, warnings_of
from situation_record import deviations
from situation_session import Session, run_together

SETTLING = 1.0


def node_2d_targets_play_smoothly(run):
    """A Node2D at 200 pixels per second; 100 pixels are recorded as a meter."""
    session = Session("Node2D", "motion", seconds=4.0, node="Node2D", speed=200.0)
    run_together(run, [session])
    findings = Findings([session])
    truth, shown = truth_of(session, "A"), session.clients[0].record
    samples = shown.shown("A", shown.begin + SETTLING, truth.samples[-1].wall)
    findings.smooth(session.name, samples)
    findings.even(session.name, samples)
    findings.delay(session.name, samples, truth, 0.0, 0.3, 0.05)
    found = deviations(samples, truth)
    worst = percentile(found, 0.99) if found else float("inf")
    print(f"   {session.name}: {100 * worst:.2f} pixels beside its path", flush=True)
    # A position tolerance of 0.5 pixels, and as much for a point at the lever arm.
    findings.check(worst <= 0.01, f"{session.name}: {100 * worst:.2f} pixels beside its path")
    findings.raise_failures()


def faults_of_a_scene_are_reported_once(run):
    """Names that the engine made up, bodies without a node, owners that are not connected."""
    control = Session("no fault", "faults", seconds=5.0)
    name = Session("auto-named node", "faults", seconds=5.0, fault="name")
    absent = Session("body without a node", "faults", seconds=5.0, fault="absent")
    owner = Session("owner that is not connected", "faults", clients=2, seconds=5.0, fault="owner", server_relay=False)
    sessions = [control, name, absent, owner]
    run_together(run, sessions)
    findings = Findings(sessions)
    # The process that has to warn, and what the warning names.
    expected = {control: None, name: (name.server, "@Node3D@"), absent: (absent.clients[0], "node"), owner: (owner.clients[1], "B")}
    for session in sessions:
        for process in session.processes():
            texts = [text for text in warnings_of(process) if "MotorSynchronizer" in text]
            print(f"   {session.name}: {process.name} warns: {texts}", flush=True)
            for text in set(texts):
                findings.check(texts.count(text) == 1, f"{session.name}: {process.name} warns {texts.count(text)} times: {text}")
        if expected[session] is None:
            findings.check(not any(warnings_of(process) for process in session.processes()), f"{session.name}: there are warnings")
            continue
        process, word = expected[session]
        found = [text for text in warnings_of(process) if "MotorSynchronizer" in text and word in text]
        findings.check(len(found) == 1, f"{session.name}: {process.name} has {len(found)} warnings with '{word}' instead of 1")
        listed = process.report()["warnings"]
        findings.check(any(word in text for text in listed), f"{session.name}: get_setup_warnings() of {process.name} is {listed}")
    findings.raise_failures()


CASES = (
    node_2d_targets_play_smoothly,
    faults_of_a_scene_are_reported_once,
)
