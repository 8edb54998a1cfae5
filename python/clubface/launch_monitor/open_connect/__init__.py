"""GSPro Open Connect v1: the JSON messages that launch monitors and simulators exchange over a local socket.

:class:`Listener` takes the place of the simulator and yields the shots of a monitor. :class:`Sender` takes the place of
the monitor and sends launches to a simulator.
"""

from __future__ import annotations

from clubface.launch_monitor.open_connect.listener import Listener as Listener
from clubface.launch_monitor.open_connect.messages import (
    Message as Message,
    MessageError as MessageError,
    from_json as from_json,
    recorded as recorded,
)
from clubface.launch_monitor.open_connect.outgoing import heartbeat as heartbeat, to_json as to_json
from clubface.launch_monitor.open_connect.sender import Reply as Reply, Sender as Sender
