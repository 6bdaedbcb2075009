"""Results: a line for each check, and a table with a row for each oracle."""

import numpy as np


class Report:
    """The lines of the checks."""

    def __init__(self):
        self.lines = []

    def check(self, oracle, name, errors, bound):
        """Adds a check, given the error of each case. It passes if there are cases and no error exceeds the bound."""
        errors = np.asarray(errors, float).ravel()
        worst = float(np.max(errors)) if len(errors) and not np.isnan(errors).any() else float("nan")
        self.lines.append(Line(oracle, name, len(errors), worst, bound))

    def count(self, oracle, name, successes):
        """Adds a check whose cases either succeed or fail."""
        self.check(oracle, name, [0.0 if success else 1.0 for success in successes], 0.0)


class Line:
    """One check."""

    def __init__(self, oracle, name, cases, worst, bound):
        self.oracle, self.name, self.cases, self.worst, self.bound = oracle, name, cases, worst, bound
        self.passed = bool(worst <= bound)

    def __str__(self):
        name = f"{self.oracle}: {self.name}"
        verdict = "ok" if self.passed else "FAILED"
        return f"{name:<92} {self.cases:>7,} cases  worst {self.worst:8.2g}  bound {self.bound:.0e}  {verdict}"

    def share(self):
        """The worst error relative to the bound; infinity if the check failed."""
        if not self.passed:
            return float("inf")
        return self.worst / self.bound if self.bound else 0.0


def table(lines):
    """A row for each oracle: checks, cases, the worst error, and the check closest to its bound."""
    rows = [("oracle", "checks", "cases", "worst error", "closest to its bound")]
    for oracle in dict.fromkeys(line.oracle for line in lines):
        own = [line for line in lines if line.oracle == oracle]
        worst = float("nan") if any(np.isnan(line.worst) for line in own) else max(line.worst for line in own)
        closest = max(own, key=Line.share)
        share = f"{closest.share():.0%}" if closest.passed else "FAILED"
        rows.append((oracle, str(len(own)), f"{sum(line.cases for line in own):,}", f"{worst:.2g}",
                     f"{share:>6} {closest.name}"))
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    texts = []
    for row in rows:
        cells = [row[0].ljust(widths[0]), *(cell.rjust(width) for cell, width in zip(row[1:4], widths[1:4])), row[4]]
        texts.append("  ".join(cells).rstrip())
    texts.insert(1, "-" * max(map(len, texts)))
    return "\n".join(texts)


def summary(lines):
    """(the line that tools/test parses, the exit code)"""
    failed = sum(not line.passed for line in lines)
    passed = len(lines) - failed
    return f"[algebra] {passed} passed, {failed} failed", 1 if failed or not passed else 0
