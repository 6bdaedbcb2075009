extends RefCounted
## Finds free UDP ports on this machine.

## Number of ports that [method find_free] tries.
const MAX_ATTEMPTS := 32
const MAX_PORT := 65535


## The first free port from [param first] on, or 0 if there is none among the next ones.
static func find_free(first: int) -> int:
	for port: int in range(first, mini(first + MAX_ATTEMPTS, MAX_PORT + 1)):
		var probe := PacketPeerUDP.new()
		if probe.bind(port) == OK:
			probe.close()
			return port
	return 0
