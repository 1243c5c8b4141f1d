"""One program from start to end: its exit, its CPU time, and how that grew while it ran."""
import os
import resource
import subprocess
import threading
import time

TICK = 0.1


class Finished:
    """What is known of a process that ended."""

    def __init__(self, status, signal, output, errors, cpu_seconds, wall_seconds, peak_mb, clock, in_time):
        self.status, self.signal, self.in_time = status, signal, in_time
        self.output, self.errors = output, errors
        self.cpu_seconds, self.wall_seconds, self.peak_mb = cpu_seconds, wall_seconds, peak_mb
        self._clock = clock

    def cpu_at(self, wall):
        """CPU seconds that were used `wall` seconds after the start: other programs on the machine do not count."""
        before = (0.0, 0.0)
        for after in self._clock:
            if after[0] >= wall:
                share = (wall - before[0]) / max(after[0] - before[0], 1e-9)
                return before[1] + share * (after[1] - before[1])
            before = after
        return before[1]


def _cpu_of(pid):
    """CPU seconds of a living process and all its threads; None once it is gone."""
    try:
        with open(f"/proc/{pid}/stat", encoding="ascii", errors="replace") as file:
            fields = file.read().rpartition(")")[2].split()
    except OSError:
        return None
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def run(command, cpu_limit, wall_limit=float("inf")):
    """Runs the command to its end. Past `cpu_limit` CPU seconds the system ends it by SIGXCPU, past `wall_limit` seconds
    it is killed and not in time. Interrupted, it takes the child with it."""

    def limit():
        seconds = max(1, int(cpu_limit))
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 5))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    start = time.monotonic()
    child = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                             preexec_fn=limit)
    texts = {}
    readers = [threading.Thread(target=lambda n=n, s=s: texts.__setitem__(n, s.read()), daemon=True)
               for n, s in (("out", child.stdout), ("err", child.stderr))]
    for reader in readers:
        reader.start()
    clock, in_time = [], True
    try:
        while True:
            pid, state, usage = os.wait4(child.pid, os.WNOHANG)
            now = time.monotonic() - start
            if pid != 0:
                break
            used = _cpu_of(child.pid)
            if used is not None:
                clock.append((now, used))
            if now > wall_limit and in_time:
                in_time = False
                child.kill()
            time.sleep(TICK)
    except BaseException:
        child.kill()
        os.wait4(child.pid, 0)
        raise
    # Popen did not see the end; it must not wait for a process of the same number later.
    child.returncode = os.waitstatus_to_exitcode(state)
    for reader in readers:
        reader.join()
    child.stdout.close()
    child.stderr.close()
    cpu = usage.ru_utime + usage.ru_stime
    clock.append((now, cpu))
    code = child.returncode
    return Finished(max(code, 0), max(-code, 0), texts["out"].decode("utf-8", "replace"),
                    texts["err"].decode("utf-8", "replace"), cpu, now, usage.ru_maxrss / 1024, clock,
                    in_time)
