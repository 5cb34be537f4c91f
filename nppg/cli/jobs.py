"""Many runs at a time, for the verbs that do them."""

from __future__ import annotations

import argparse
from collections.abc import Sequence

from nppg.errors import NppgError
from nppg.experiments import jobs
from nppg.experiments.cluster import Cluster
from nppg.experiments.many import Pool, Processes, available_cores
from nppg.learning.options import at_least


def add_pool(
    parser: argparse.ArgumentParser | argparse._ArgumentGroup,
    jobs: str = "runs at a time (default: the cores there are)",
) -> None:
    """Where the runs are done; `jobs` is what the help says of --jobs."""
    parser.add_argument("--jobs", type=int, metavar="N", help=jobs)
    parser.add_argument(
        "--cluster",
        metavar="ADDRESS",
        help="do the runs on the workers of a dask.distributed scheduler, tcp://HOST:PORT",
    )


def pool(options: argparse.Namespace) -> Pool:
    """Raises NppgError."""
    if options.cluster is None:
        at_least("jobs", available_cores() if options.jobs is None else options.jobs, 1)
        return Processes(options.jobs or available_cores())
    if options.jobs is not None:
        raise NppgError("--jobs is about this machine, and a cluster has its workers: give one of --jobs and --cluster")
    return Cluster(options.cluster)


def do(wanted: Sequence[jobs.Job], pool: Pool, tell: bool = True) -> bool:
    """Does the runs that are not finished, and prints a line for each. Whether there were any. Raises NppgError."""
    done = 0
    for count, (job, seconds) in enumerate(jobs.do(wanted, pool), 1):
        done += seconds > 0
        how = f"{seconds:.0f} s" if seconds else "done before"
        if tell:
            print(f"{count:3d} of {len(wanted)}: {job}, {job.result()}, {how}", flush=True)
    return done > 0
