"""What fuzzing found: programs that once ended in a traceback, a hang or a wrong tree."""

from __future__ import annotations

import pytest

from trajopt_cli.errors import InputError
from trajopt_cli.motion import TextFile
from trajopt_cli.rapid.reader import run_program


def error(body: str, data: str = "") -> str:
    text = f"MODULE m\n{data}\nPROC main()\n{body}\nENDPROC\nENDMODULE\n"
    with pytest.raises(InputError) as caught:
        run_program([TextFile("m.mod", text, "utf-8")])
    return caught.value.message


def test_a_socket_is_asked_for_where_other_data_is_given() -> None:
    message = error("WaitTime SocketGetStatus(w);", "VAR wobjdata w;")
    assert message == "SocketGetStatus takes a socketdev, and w is a wobjdata"


def test_an_element_of_data_of_a_type_that_nobody_declares() -> None:
    message = error("x:=s{2};", "VAR shelf s{2}:=[[1,TRUE],[2,FALSE]];\nVAR num x;")
    assert message == "'s{2}' is of type shelf, which is declared nowhere"


def test_the_sizes_of_an_array_of_process_data() -> None:
    message = error("VAR socketdev s{2,3};\nFOR k FROM 1 TO Dim(s,2) DO\nWaitTime 1/(3-k);\nENDFOR")
    assert message == "division by zero in '/'"  # in the third pass
