"""A cluster that the tests share: two processes of one thread each."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from distributed import Client

from trajopt_cli.parameter_study.cluster import local_client

MEMORY = 600e6  # bytes of a worker


@pytest.fixture(scope="session")
def client() -> Iterator[Client]:
    with local_client(2, MEMORY) as client:
        yield client
