"""The workers of a dask.distributed cluster, for nppg.experiments.many."""

from __future__ import annotations

import logging
from collections.abc import Mapping, Sequence
from concurrent.futures import CancelledError, Future
from importlib.metadata import version
from typing import Any

from nppg.errors import NppgError
from nppg.experiments.many import Answer, Lost, Worker, called

_TIMEOUT = 10  # seconds until the scheduler has answered and has a worker


class Cluster:
    """That of the scheduler at this address, tcp://HOST:PORT. It repeats the calls of killed workers by itself."""

    shares_files = False

    def __init__(self, address: str):
        self._address = address

    def open(self, count: int) -> Sequence[Worker]:
        try:
            from distributed import Client
        except ModuleNotFoundError as error:
            if error.name != "distributed":
                raise
            raise NppgError("a cluster needs dask.distributed: pip install 'nppg[cluster]'") from None
        logging.getLogger("distributed.client").setLevel(logging.CRITICAL)  # what it has to tell is raised here
        try:
            client = Client(self._address, timeout=_TIMEOUT, set_as_default=False)
        except (OSError, ValueError, AssertionError):
            raise NppgError(f"{self._address}: no scheduler of dask.distributed answers there") from None
        try:
            self._check(client)
        except BaseException:
            client.close()
            raise
        return [_Place(client, self._address)] * count

    def _check(self, client: Any) -> None:
        """Raises NppgError where the cluster cannot do calls as this machine would."""
        try:
            client.wait_for_workers(1, timeout=_TIMEOUT)
        except TimeoutError:
            raise NppgError(f"{self._address}: the scheduler has no workers") from None
        for worker, threads in client.nthreads().items():
            if threads > 1:
                message = f"it works in {threads} threads, but Prolog in one of them alone"
                raise NppgError(f"{worker}: {message}: start it by dask worker --nthreads 1, with --nworkers for more")
        known = client.get_versions(packages=["nppg"])
        for name, found in {"the scheduler": known["scheduler"], **known["workers"]}.items():
            if (there := _version(found)) != version("nppg"):
                raise NppgError(f"{name}: nppg is {there or 'missing'} there, and {version('nppg')} here")


class Abandoned(Exception):
    """Nobody waits any more for what a call gives."""


def heed_abandoned() -> None:
    """To be called by a call, now and then. Raises Abandoned."""
    from distributed import get_worker

    worker = get_worker()
    if worker.state.tasks[worker.get_current_task()].state != "executing":
        raise Abandoned


def _version(found: Mapping[str, Any]) -> str | None:
    return found["packages"].get("nppg")


class _Place:
    """One that does all calls that it is given, on as many workers as there are."""

    def __init__(self, client: Any, address: str):
        self._client = client
        self._executor = client.get_executor(pure=False)
        self._address = address

    def submit(self, call: bytes) -> Future[Answer]:
        return self._executor.submit(called, call)

    def result(self, future: Future[Answer]) -> Answer:
        from distributed import KilledWorker

        try:
            return future.result()
        except KilledWorker:
            raise Lost(repeatable=False) from None
        except CancelledError:
            raise NppgError(f"{self._address}: the scheduler has gone") from None

    def interrupt(self) -> None:
        """Workers are not interrupted: their calls heed that they are abandoned, or end as they would have."""
        self._executor.shutdown(wait=False)

    def close(self) -> None:
        self._client.close()
