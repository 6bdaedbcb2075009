"""Counts what was compared, and says so: a line for each check, and a table with a row for each oracle."""

import numpy as np


class Report:
    """What the checks found."""

    def __init__(self):
        self.lines = []

    def check(self, oracle, name, errors, bound):
        """Errors of all cases of a check, which passes if it has cases and each error is at most the bound."""
        errors = np.asarray(errors, float).ravel()
        worst = float(np.max(errors)) if len(errors) and not np.isnan(errors).any() else float("nan")
        self.lines.append(Line(oracle, name, len(errors), worst, bound))

    def count(self, oracle, name, answers):
        """The same for cases that are right or wrong."""
        self.check(oracle, name, [0.0 if answer else 1.0 for answer in answers], 0.0)


class Line:
    """One check."""

    def __init__(self, oracle, name, cases, worst, bound):
        self.oracle, self.name, self.cases, self.worst, self.bound = oracle, name, cases, worst, bound
        self.good = bool(worst <= bound)

    def __str__(self):
        name = f"{self.oracle}: {self.name}"
        verdict = "ok" if self.good else "FAILED"
        return f"{name:<92} {self.cases:>7,} cases  worst {self.worst:8.2g}  bound {self.bound:.0e}  {verdict}"

    def share(self):
        """How much of the bound the worst error takes; more than 1 if it failed."""
        if not self.good:
            return float("inf")
        return self.worst / self.bound if self.bound else 0.0


def table(lines):
    """A row for each oracle: checks, cases, the worst error, and the check that comes closest to its bound."""
    rows = [("oracle", "checks", "cases", "worst error", "closest to its bound")]
    for oracle in dict.fromkeys(line.oracle for line in lines):
        own = [line for line in lines if line.oracle == oracle]
        worst = float("nan") if any(np.isnan(line.worst) for line in own) else max(line.worst for line in own)
        closest = max(own, key=Line.share)
        share = f"{closest.share():.0%}" if closest.good else "FAILED"
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
    """(the line that tools/test reads, the exit code)."""
    failed = sum(not line.good for line in lines)
    passed = len(lines) - failed
    return f"[algebra] {passed} passed, {failed} failed", 1 if failed or not passed else 0
