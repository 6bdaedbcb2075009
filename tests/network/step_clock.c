// Shifts the wall clock of a process by the seconds in the file STEP_CLOCK_FILE, a 64-bit integer that
// may change at any time. Monotonic clocks keep. Loaded with LD_PRELOAD. Not for the system's ENet, with
// which some distributions build Godot: its timeouts use the wall clock.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

static int64_t step(void) {
	static const volatile int64_t *shared = NULL;
	if (shared == NULL) {
		const int file = open(getenv("STEP_CLOCK_FILE"), O_RDONLY);
		shared = mmap(NULL, sizeof(int64_t), PROT_READ, MAP_SHARED, file, 0);
	}
	return *shared;
}

int clock_gettime(clockid_t clock, struct timespec *time) {
	const int result = (int)syscall(SYS_clock_gettime, clock, time);
	if (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE) {
		time->tv_sec += step();
	}
	return result;
}

int gettimeofday(struct timeval *restrict value, void *restrict zone) {
	struct timespec time;
	Dl_info caller;
	(void)zone;
	clock_gettime(CLOCK_REALTIME, &time);
	if (dladdr(__builtin_return_address(0), &caller) != 0 && strstr(caller.dli_fname, "libenet") != NULL) {
		time.tv_sec -= step();
	}
	value->tv_sec = time.tv_sec;
	value->tv_usec = time.tv_nsec / 1000;
	return 0;
}

time_t time(time_t *result) {
	struct timespec now;
	clock_gettime(CLOCK_REALTIME, &now);
	if (result != NULL) {
		*result = now.tv_sec;
	}
	return now.tv_sec;
}

// Godot opens extensions with RTLD_DEEPBIND, with which they would not find the functions above.
void *dlopen(const char *path, int flags) {
	void *(*next)(const char *, int) = (void *(*)(const char *, int))dlsym(RTLD_NEXT, "dlopen");
	return next(path, flags & ~RTLD_DEEPBIND);
}
