"""GSPro Open Connect v1: the JSON messages by which launch monitors and simulators talk over a local socket.

:class:`Listener` stands in for the simulator and yields the shots of a monitor; :class:`Sender` stands in for the
monitor and sends launches to a simulator.
"""

from __future__ import annotations

from clubface.launch_monitor.open_connect.listener import Listener
from clubface.launch_monitor.open_connect.messages import Message, MessageError, from_json, recorded
from clubface.launch_monitor.open_connect.outgoing import heartbeat, to_json
from clubface.launch_monitor.open_connect.sender import Reply, Sender

__all__ = ["Listener", "Message", "MessageError", "Reply", "Sender", "from_json", "heartbeat", "recorded", "to_json"]
