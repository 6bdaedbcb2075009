extends RefCounted
## Ends the process when a test blocks the main thread, which also blocks the timers of the scene
## tree.

const POLL_MILLISECONDS := 100

var _thread := Thread.new()
var _mutex := Mutex.new()
var _deadline := 0
var _subject := ""
var _stopped := false


func _init() -> void:
	_thread.start(_watch)


## Starts the time limit of [param subject], in place of the previous one.
func allow(subject: String, seconds: float) -> void:
	_mutex.lock()
	_subject = subject
	_deadline = Time.get_ticks_msec() + roundi(seconds * 1000.0)
	_mutex.unlock()


## Ends the thread. Must be called before the last reference is dropped.
func stop() -> void:
	_mutex.lock()
	_stopped = true
	_mutex.unlock()
	_thread.wait_to_finish()


func _watch() -> void:
	while true:
		OS.delay_msec(POLL_MILLISECONDS)
		_mutex.lock()
		var stopped := _stopped
		var expired := _deadline > 0 and Time.get_ticks_msec() > _deadline
		var subject := _subject
		_mutex.unlock()
		if stopped:
			return
		if expired:
			print("FAIL %s: blocks the main thread; the run is aborted" % subject)
			OS.kill(OS.get_process_id())
			return
