"""EGM's messages for Google's own library, from the field numbers that are public of the controller's file."""

from __future__ import annotations

from typing import Any

import pytest

_protobuf = pytest.importorskip("google.protobuf")
from google.protobuf import descriptor_pb2, descriptor_pool, message_factory  # noqa: E402

_KINDS = descriptor_pb2.FieldDescriptorProto
# Of every message its fields: number, name, and a type or the name of a message; * for any number of them.
_MESSAGES: dict[str, list[tuple[int, str, Any]]] = {
    "EgmHeader": [(1, "seqno", _KINDS.TYPE_UINT32), (2, "tm", _KINDS.TYPE_UINT32), (3, "mtype", _KINDS.TYPE_INT32)],
    "EgmJoints": [(1, "*joints", _KINDS.TYPE_DOUBLE)],
    "EgmCartesian": [(i + 1, name, _KINDS.TYPE_DOUBLE) for i, name in enumerate("xyz")],
    "EgmQuaternion": [(i + 1, f"u{i}", _KINDS.TYPE_DOUBLE) for i in range(4)],
    "EgmClock": [(1, "sec", _KINDS.TYPE_UINT64), (2, "usec", _KINDS.TYPE_UINT64)],
    "EgmPose": [(1, "pos", "EgmCartesian"), (2, "orient", "EgmQuaternion")],
    "EgmPlanned": [
        (1, "joints", "EgmJoints"),
        (2, "cartesian", "EgmPose"),
        (3, "externalJoints", "EgmJoints"),
        (4, "time", "EgmClock"),
    ],
    "EgmSpeedRef": [(1, "joints", "EgmJoints"), (3, "externalJoints", "EgmJoints")],
    "EgmMotorState": [(1, "state", _KINDS.TYPE_INT32)],
    "EgmRobot": [
        (1, "header", "EgmHeader"),
        (2, "feedBack", "EgmPlanned"),  # the same fields
        (3, "planned", "EgmPlanned"),
        (4, "motorState", "EgmMotorState"),
        (6, "mciConvergenceMet", _KINDS.TYPE_BOOL),
        (10, "utilizationRate", _KINDS.TYPE_DOUBLE),
    ],
    "EgmSensor": [(1, "header", "EgmHeader"), (2, "planned", "EgmPlanned"), (3, "speedRef", "EgmSpeedRef")],
}


def _classes() -> dict[str, Any]:
    file = descriptor_pb2.FileDescriptorProto(name="egm_for_tests.proto", package="egm_for_tests", syntax="proto2")
    for name, fields in _MESSAGES.items():
        message = file.message_type.add(name=name)
        for number, field, kind in fields:
            label = _KINDS.LABEL_REPEATED if field.startswith("*") else _KINDS.LABEL_OPTIONAL
            added = message.field.add(name=field.lstrip("*"), number=number, label=label)
            if isinstance(kind, str):
                added.type, added.type_name = _KINDS.TYPE_MESSAGE, f".egm_for_tests.{kind}"
            else:
                added.type = kind
    pool = descriptor_pool.DescriptorPool()
    pool.Add(file)
    return {
        name: message_factory.GetMessageClass(pool.FindMessageTypeByName(f"egm_for_tests.{name}")) for name in _MESSAGES
    }


_CLASSES = _classes()
EgmRobot, EgmSensor = _CLASSES["EgmRobot"], _CLASSES["EgmSensor"]
