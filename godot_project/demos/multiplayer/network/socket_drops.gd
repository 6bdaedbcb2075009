extends RefCounted
## Counts datagrams that the operating system dropped because a process did not read a UDP socket in
## time. Neither the sender nor the receiver notices this loss.

## The kernel's tables of UDP sockets. Linux only; elsewhere nothing is counted.
const TABLES: PackedStringArray = ["/proc/net/udp", "/proc/net/udp6"]
const LOCAL_ADDRESS := 1
## Columns of a row; the last one is the number of dropped datagrams.
const COLUMNS := 13


## Datagrams dropped since the sockets with these local ports were opened.
static func count(ports: PackedInt32Array) -> int:
	var drops := 0
	for table: String in TABLES:
		var file := FileAccess.open(table, FileAccess.READ)
		while file != null and not file.eof_reached():
			drops += _parse(file.get_line(), ports)
	return drops


static func _parse(row: String, ports: PackedInt32Array) -> int:
	var columns := row.split(" ", false)
	if columns.size() < COLUMNS or not columns[LOCAL_ADDRESS].contains(":"):
		return 0
	var port := columns[LOCAL_ADDRESS].get_slice(":", 1).hex_to_int()
	return columns[columns.size() - 1].to_int() if ports.has(port) else 0
