// GCC 12's ThreadSanitizer does not know pthread_mutex_clocklock(), by which std::timed_mutex waits: it takes what such
// a mutex guards for unguarded, and its unlocking for a fault. Waiting by pthread_mutex_timedlock(), which it knows, it
// sees both ends. Linked into builds with -fsanitize=thread alone.
#define _GNU_SOURCE
#include <pthread.h>
#include <time.h>

int pthread_mutex_clocklock(pthread_mutex_t* mutex, clockid_t clock, const struct timespec* until) {
    const long k_second_ns = 1000000000;
    struct timespec theirs, now;
    clock_gettime(clock, &theirs);
    clock_gettime(CLOCK_REALTIME, &now);
    now.tv_sec += until->tv_sec - theirs.tv_sec;
    now.tv_nsec += until->tv_nsec - theirs.tv_nsec;
    if (now.tv_nsec < 0) {
        now.tv_nsec += k_second_ns;
        --now.tv_sec;
    } else if (now.tv_nsec >= k_second_ns) {
        now.tv_nsec -= k_second_ns;
        ++now.tv_sec;
    }
    return pthread_mutex_timedlock(mutex, &now);
}
