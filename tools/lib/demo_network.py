"""The options of the demo that impair the network between clients and the server, in each direction."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Condition:
    """One impairment; `description` is text with the value in place of {}."""

    name: str
    metavar: str
    maximum: int
    help: str
    description: str


CONDITIONS = (
    Condition("loss", "PERCENT", 90, "packets that are lost", "{} % loss"),
    Condition("burst", "PACKETS", 100, "mean length of a loss burst", "in bursts of {} packets"),
    Condition("delay", "MS", 2000, "minimum delay", "{} ms delay"),
    Condition("jitter", "MS", 2000, "maximum of the additional, random delay, which reorders packets", "up to {} ms jitter"),
    Condition("reorder", "PERCENT", 100, "additional packets that are reordered", "{} % reordered"),
    Condition("duplicate", "PERCENT", 100, "packets that arrive twice", "{} % duplicated"),
    Condition("rate", "BYTES", 10 ** 9, "bandwidth in bytes per second, with a short queue (0: unlimited)", "at most {} bytes/s"),
)


def add_arguments(parser, number_within):
    """Adds the options as a group; `number_within(minimum, maximum)` returns their types."""
    group = parser.add_argument_group("network", "impairments in each direction, simulated by a seeded proxy in front of each client")
    for condition in CONDITIONS:
        group.add_argument("--" + condition.name, type=number_within(0, condition.maximum), default=0,
                           metavar=condition.metavar, help=condition.help)


def client_arguments(options, seed):
    """The arguments of a client of the demo."""
    chosen = [f"--{condition.name}={getattr(options, condition.name)}" for condition in CONDITIONS
              if getattr(options, condition.name)]
    return [*chosen, f"--seed={seed}"] if chosen else []


def describe(options):
    """The impairments as text; empty if there are none."""
    chosen = [condition.description.format(getattr(options, condition.name)) for condition in CONDITIONS
              if getattr(options, condition.name)]
    return ", ".join(chosen)


def max_delay(options):
    """The maximum delay of a packet in the network, in seconds."""
    return (options.delay + options.jitter) / 1000.0
