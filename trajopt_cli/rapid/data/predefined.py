"""The data every controller has: speeds, zones, tool0, wobj0, load0. Figures as in ABB's reference manual."""

from __future__ import annotations

from functools import cache
from math import pi
from string import ascii_lowercase, ascii_uppercase, digits

from trajopt_cli.rapid.data.datatypes import (
    LOADDATA,
    NUM,
    SPEEDDATA,
    STRING,
    TOOLDATA,
    WOBJDATA,
    ZONEDATA,
    Data,
    Type,
    Value,
)

_SPEEDS = (
    5, 10, 20, 30, 40, 50, 60, 80, 100, 150, 200, 300, 400, 500, 600, 800,
    1000, 1500, 2000, 2500, 3000, 4000, 5000, 6000, 7000,
)  # fmt: skip
# vmax on a controller is the robot's own highest TCP speed; 5 m/s is what ABB gives for robots without a figure.
VMAX = 5000.0  # mm/s
_V_ORI, _V_LEAX, _V_REAX = 500.0, 5000.0, 1000.0  # deg/s, mm/s, deg/s

# pzone_tcp, pzone_ori, pzone_eax [mm], zone_ori [deg], zone_leax [mm], zone_reax [deg]. z0 is a fly-by, not a stop.
_ZONES = {
    "z0": (0.3, 0.3, 0.3, 0.03, 0.3, 0.03),
    "z1": (1, 1, 1, 0.1, 1, 0.1),
    "z5": (5, 8, 8, 0.8, 8, 0.8),
    "z10": (10, 15, 15, 1.5, 15, 1.5),
    "z15": (15, 23, 23, 2.3, 23, 2.3),
    "z20": (20, 30, 30, 3.0, 30, 3.0),
    "z30": (30, 45, 45, 4.5, 45, 4.5),
    "z40": (40, 60, 60, 6.0, 60, 6.0),
    "z50": (50, 75, 75, 7.5, 75, 7.5),
    "z60": (60, 90, 90, 9.0, 90, 9.0),
    "z80": (80, 120, 120, 12, 120, 12),
    "z100": (100, 150, 150, 15, 150, 15),
    "z150": (150, 225, 225, 23, 225, 23),
    "z200": (200, 300, 300, 30, 300, 30),
}

# Sets of characters for StrFind, StrMap and StrOrder.
_ACCENTED = "ÀÁÂÃÄÅÆÇÈÉÊËÌÍÎÏÑÒÓÔÕÖØÙÚÛÜ"
_STRINGS = {
    "str_digit": digits,
    "str_lower": ascii_lowercase + _ACCENTED.lower(),
    "str_upper": ascii_uppercase + _ACCENTED,
    "str_white": " \t\r\n\f\v",
}

_IDENTITY: Data = ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0))
_LOAD0: Data = (0.001, (0.0, 0.0, 0.001), (1.0, 0.0, 0.0, 0.0), 0.0, 0.0, 0.0)


def _counted(first: int, names: str) -> dict[str, tuple[Type, Data]]:
    """Names in the order of their numbers."""
    return {name.lower(): (NUM, float(number)) for number, name in enumerate(names.split(), start=first)}


WAIT_MAX = 8388608.0  # s, about 97 days: a num that is exact
# About operator, files, sockets and the controller, by name in lower case.
_CONSTANTS: dict[str, tuple[Type, Data]] = {
    **_counted(-1, "btnNone btnOK btnAbrtRtryIgn btnOKCancel btnRetryCancel btnYesNo btnYesNoCancel"),
    **_counted(0, "resUnkwn resOK resAbort resRetry resIgnore resCancel resYes resNo"),
    **_counted(0, "iconNone iconInfo iconWarning iconError"),
    **_counted(1, "SOCKET_CREATED SOCKET_CONNECTED SOCKET_BOUND SOCKET_LISTENING SOCKET_CLOSED"),
    **_counted(0, "OP_UNDEF OP_AUTO OP_MAN_PROG OP_MAN_TEST"),
    **_counted(0, "RUN_UNDEF RUN_CONT_CYCLE RUN_INSTR_FWD RUN_INSTR_BWD RUN_SIM RUN_STEP_MOVE"),
    **_counted(0, "EVENT_NONE EVENT_POWERON EVENT_START EVENT_STOP EVENT_QSTOP EVENT_RESTART EVENT_RESET EVENT_STEP"),
    **_counted(0, "HANDLER_NONE HANDLER_BWD HANDLER_ERR HANDLER_UNDO"),
    **_counted(0, "LEVEL_NORMAL LEVEL_TRAP LEVEL_SERVICE"),
    **_counted(0, "SIGORIG_NONE SIGORIG_CFG SIGORIG_ALIAS"),
    **{name: (NUM, size) for name, size in {"usint": 1.0, "uint": 2.0, "udint": 4.0, "ulint": 8.0}.items()},
    **{name: (NUM, -size) for name, size in {"sint": 1.0, "int": 2.0, "dint": 4.0, "lint": 8.0}.items()},
    "edge": (NUM, 2.0),
    "eof": (STRING, "EOF"),
    "eof_num": (NUM, 9.998e36),
    "eof_bin": (NUM, -1.0),
    "wait_max": (NUM, WAIT_MAX),
    "stempty": (STRING, ""),
    "diskhome": (STRING, "HOME:"),
    "disktemp": (STRING, "TEMP:"),
}


@cache
def predefined() -> dict[str, Value]:
    """Values by name in lower case."""
    table: dict[str, tuple[Type, Data]] = {
        "pi": (NUM, pi),
        "load0": (LOADDATA, _LOAD0),
        "tool0": (TOOLDATA, (True, _IDENTITY, _LOAD0)),
        "wobj0": (WOBJDATA, (False, True, "", _IDENTITY, _IDENTITY)),
        "fine": (ZONEDATA, (True, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)),
        "vmax": (SPEEDDATA, (VMAX, _V_ORI, _V_LEAX, _V_REAX)),
        # Names for the states of signals.
        **{name: (NUM, 1.0) for name in ("high", "on")},
        **{name: (NUM, 0.0) for name in ("low", "off")},
        "edge": (NUM, 2.0),
        **{name: (STRING, characters) for name, characters in _STRINGS.items()},
        **_CONSTANTS,
    }
    table |= {f"v{v}": (SPEEDDATA, (float(v), _V_ORI, _V_LEAX, _V_REAX)) for v in _SPEEDS}
    table |= {f"vrot{v}": (SPEEDDATA, (0.0, 0.0, 0.0, float(v))) for v in (1, 2, 5, 10, 20, 50, 100)}
    table |= {f"vlin{v}": (SPEEDDATA, (0.0, 0.0, float(v), 0.0)) for v in (10, 20, 50, 100, 200, 500, 1000)}
    table |= {name: (ZONEDATA, (False, *map(float, sizes))) for name, sizes in _ZONES.items()}
    return {name: Value(type_, data) for name, (type_, data) in table.items()}


# Predefined data that a program may change.
VARIABLES: dict[str, Type] = {f"reg{i}": NUM for i in range(1, 6)}

# Names of the errors a program may handle. Their numbers are the controller's own affair and differ between versions;
# here they count from 1001, which no program can see but by comparing names.
_ERROR_NAMES = """
    ERR_ACC_TOO_LOW ERR_ADDR_INUSE ERR_ALIASIO_DEF ERR_ALIASIO_TYPE ERR_ALRDYCNT ERR_ALRDY_MOVING ERR_AO_LIM
    ERR_ARGDUPCND ERR_ARGNAME ERR_ARGNOTPER ERR_ARGNOTVAR ERR_ARGVALERR ERR_AXIS_ACT ERR_AXIS_IND ERR_AXIS_MOVING
    ERR_AXIS_PAR ERR_BUSSTATE ERR_BWDLIMIT ERR_CALC_DIVZERO ERR_CALC_NEG ERR_CALC_OVERFLOW ERR_CALLIO_INTER
    ERR_CALLPROC ERR_CNTNOTVAR ERR_CNV_CONNECT ERR_CNV_DROPPED ERR_CNV_NOT_ACT ERR_COLL_STOP ERR_CONC_MAX
    ERR_DEV_MAXTIME ERR_DIPLAG_LIM ERR_DIVZERO ERR_EXCRTYMAX ERR_EXECPHR ERR_FILEACC ERR_FILEEXIST ERR_FILEOPEN
    ERR_FILNOTFND ERR_FILESIZE ERR_FNCNORET ERR_FRAME ERR_GO_LIM ERR_ILLDIM ERR_ILLQUAT ERR_ILLRAISE ERR_INOMAX
    ERR_INOISSAFE ERR_INT_MAXVAL ERR_INT_NOTVAL ERR_INVDIM ERR_IODISABLE ERR_IOENABLE ERR_LOADED ERR_LOADID_FATAL
    ERR_MAXINTVAL ERR_MODULE ERR_MOD_NOTLOADED ERR_NAME_INVALID ERR_NORUNUNIT ERR_NOTARR ERR_NOTEQDIM ERR_NOTINTVAL
    ERR_NOTPRES ERR_NOTSAVED ERR_NOT_MOVETASK ERR_NO_ALIASIO_DEF ERR_NUM_LIMIT ERR_OUTOFBND ERR_OUTSIDE_REACH
    ERR_OVERFLOW ERR_PATH ERR_PATHDIST ERR_PATH_STOP ERR_PID_MOVESTOP ERR_PID_RAISE_PP ERR_PRGMEMFULL ERR_PROGSTOP
    ERR_RANYBIN_CHK ERR_RANYBIN_EOF ERR_RCVDATA ERR_REFUNKDAT ERR_REFUNKFUN ERR_REFUNKPRC ERR_REFUNKTRP ERR_ROBLIMIT
    ERR_SC_WRITE ERR_SIGSUPSEARCH ERR_SIG_NOT_VALID ERR_SOCK_CLOSED ERR_SOCK_NOT_CONN ERR_SOCK_TIMEOUT
    ERR_SPEEDLIM_VALUE ERR_SPEED_REFRESH_LIM ERR_STARTMOVE ERR_STORE_PROF ERR_STRTOOLNG ERR_SYM_ACCESS ERR_SYNTAX
    ERR_SYNCMOVEOFF ERR_SYNCMOVEON
    ERR_TASKNAME ERR_TP_DIBREAK ERR_TP_DOBREAK ERR_TP_MAXTIME ERR_TP_NO_CLIENT ERR_TRUSTLEVEL ERR_TXTNOEXIST
    ERR_UDPUC_COMM ERR_UI_BUTTONS ERR_UI_ICON ERR_UI_INITVALUE ERR_UI_MAXMIN ERR_UI_NOTINT ERR_UNIT_PAR ERR_UNKINO
    ERR_UNKPROC ERR_UNLOAD ERR_USE_PROF ERR_WAITSYNCTASK ERR_WAIT_MAXTIME ERR_WHLSEARCH ERR_WOBJ_MOVING
    LONG_JMP_ALL_ERR
"""
ERRORS: dict[str, float] = {name: float(1001 + i) for i, name in enumerate(_ERROR_NAMES.split())}
BOOKED = 2000.0  # behind it the numbers that BookErrNo gives away, 2001 first; 1 to 90 are the programs' own
