"""Collects what a situation measured and where it fails."""

import engine_log
from pose_error import percentile
from situation_record import Truth, delays, frozen_share, largest_jump, longest_stand, speeds

SPEED = 2.0
# At most 2 % of the frames may be frozen; the rest is for a machine that does other work.
MAX_FROZEN = 0.04
# Meters beyond the step at the body's speed: one late frame of the server's or the client's.
MAX_JUMP = 0.05


class Findings:
    """Prints measures, and raises one AssertionError for all checks that failed."""

    def __init__(self, sessions):
        self.failures = []
        self._sessions = sessions
        for session in sessions:
            for process in session.processes():
                problems = engine_log.problems_of(process.log())
                if problems:
                    self.failures.append(f"{session.name}: {process.name}: {problems[0]} ({len(problems)} such lines)")
                missing = sorted({line.split()[1] for line in process.log().splitlines() if line.startswith("MISSING ")})
                if missing:
                    self.failures.append(f"{session.name}: MotorSynchronizer has no {', '.join(missing)}")

    def check(self, condition, message):
        if not condition:
            self.failures.append(message)

    def raise_failures(self):
        if self.failures:
            raise AssertionError("; ".join(dict.fromkeys(self.failures)))

    def smooth(self, name, samples, speed=SPEED, max_frozen=MAX_FROZEN, max_jump=MAX_JUMP):
        """The samples of one body move at `speed`, without a stop or a jump."""
        self.check(len(samples) > 30, f"{name}: only {len(samples)} frames show the body")
        if len(samples) <= 30:
            return
        frozen, jump = frozen_share(samples, speed), largest_jump(samples, speed)
        stand = longest_stand(samples, speed)
        print(f"   {name}: {frozen:.1%} of {len(samples)} frames frozen, standing up to {stand * 1000:.0f} ms, "
              f"largest jump {jump * 1000:.0f} mm", flush=True)
        self.check(frozen <= max_frozen, f"{name}: {frozen:.0%} of the frames are frozen")
        self.check(jump <= max_jump, f"{name}: the body jumps by {jump * 1000:.0f} mm")

    def even(self, name, samples, speed=SPEED, deviation=0.25):
        """96 of 100 speeds over spans of 50 ms deviate from `speed` by no more than the share `deviation`."""
        found = speeds(samples)
        if not found:
            return
        low, high = percentile(found, 0.02), percentile(found, 0.98)
        print(f"   {name}: speed {low:.2f} to {high:.2f} m/s, on the server {speed:.2f}", flush=True)
        self.check(low >= (1.0 - deviation) * speed and high <= (1.0 + deviation) * speed,
                   f"{name}: speeds from {low:.2f} to {high:.2f} m/s instead of {speed:.2f}")

    def delay(self, name, samples, truth, low, high, reported_within=None):
        """The median delay shown is between two bounds; returns it. All in seconds."""
        found = delays(samples, truth)
        self.check(found, f"{name}: no frame shows the body on its path")
        if not found:
            return None
        shown = percentile(found, 0.5)
        reported = percentile([sample.delay for sample in samples], 0.5)
        print(f"   {name}: delay {shown * 1000:.0f} ms, reported {reported * 1000:.0f} ms", flush=True)
        self.check(low <= shown <= high,
                   f"{name}: the delay is {shown * 1000:.0f} ms instead of {low * 1000:.0f} to {high * 1000:.0f}")
        if reported_within is not None:
            self.check(abs(shown - reported) <= reported_within,
                       f"{name}: the delay is {shown * 1000:.0f} ms, but {reported * 1000:.0f} ms are reported")
        return shown


def warnings_of(process):
    """The texts of the warnings that a process has printed."""
    return [line.split("WARNING:", 1)[1].strip() for line in process.log().splitlines() if "WARNING:" in line]


def truth_of(session, label, in_frames=False):
    return Truth(session.processes(), label, in_frames)


def median_delay(samples, truth):
    found = delays(samples, truth)
    return percentile(found, 0.5) if found else float("inf")
