"""GSPro Open Connect v1: the JSON messages that launch monitors and simulators exchange over a local socket.

:class:`Listener` takes the place of the simulator and yields the shots of a monitor. :class:`Sender` takes the place of
the monitor and sends launches to a simulator.
"""

from __future__ import annotations

from clubface.launch_monitor.open_connect.listener import Listener
from clubface.launch_monitor.open_connect.messages import Message, MessageError, from_json, recorded
from clubface.launch_monitor.open_connect.outgoing import heartbeat, to_json
from clubface.launch_monitor.open_connect.sender import Reply, Sender

__all__ = ["Listener", "Message", "MessageError", "Reply", "Sender", "from_json", "heartbeat", "recorded", "to_json"]
