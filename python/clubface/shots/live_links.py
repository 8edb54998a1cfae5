"""The connections of a live session: from monitors of several protocols, and to simulators."""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable, Sequence
from datetime import UTC, datetime
from functools import partial
from queue import Empty, SimpleQueue
from typing import NamedTuple

from clubface.errors import ClubfaceError, InputError, LinkError, in_a_line
from clubface.shots.flight_relay import FlightRelayClient, FlightRelayListener
from clubface.shots.live import LiveShot, LiveShots, live_shots
from clubface.shots.messages import PROTOCOLS, Message
from clubface.shots.open_connect import NO_ANSWER, OPEN_CONNECT, Dialect, Listener, Sender
from clubface.shots.opengolfsim import OPENGOLFSIM, OpenGolfSimSender
from clubface.shots.shot_list import completed
from clubface.support.sockets import LOOPBACK, check_port

MOST_REMARKS = 50
"""Number of recent remarks kept."""
WAIT = 0.2
"""Longest wait before checking the stop request [s]."""
DIALECTS = {each.name: each for each in (OPEN_CONNECT, OPENGOLFSIM)}
SENDERS = {OPEN_CONNECT.name: Sender, OPENGOLFSIM.name: OpenGolfSimSender}


class LinkState(NamedTuple):
    """A connection: protocol, address, and the problem, "" if it is up."""

    protocol: str
    address: str
    problem: str


class LiveRemark(NamedTuple):
    """An event on a connection, with its time as ISO text in UTC."""

    at: str
    text: str


class SimulatorAddress(NamedTuple):
    """Protocol and port of a simulator on this machine."""

    protocol: str
    port: int


def simulator_address(text: str) -> SimulatorAddress:
    """Return the simulator address from text such as "open-connect:921"; the port has a default."""
    protocol, _, port = text.partition(":")
    if protocol not in DIALECTS or (port and not (port.isascii() and port.isdecimal() and len(port) < 6)):
        raise InputError("simulator", text, " or ".join(f"{name}:{each.port}" for name, each in DIALECTS.items()))
    number = int(port) if port else DIALECTS[protocol].port
    check_port(number, 1)
    return SimulatorAddress(protocol, number)


class LiveLinks:
    """The connections of a live session, each on its own thread.

    ``listen`` gives ports by protocol, "open-connect" or "opengolfsim" (0 picks a free one); ``flight_relay`` is the
    address of a device, or a port to listen on. Every launch, measured or computed from the club data, is sent to all
    ``simulators``. ``on_change`` is called when a remark has been added.
    """

    def __init__(
        self,
        shots: LiveShots,
        *,
        listen: dict[str, int] | None = None,
        flight_relay: str | int | None = None,
        simulators: Sequence[SimulatorAddress] = (),
        on_change: Callable[[], object] = lambda: None,
    ) -> None:
        self._shots, self._on_change = shots, on_change
        self._remarks: deque[LiveRemark] = deque(maxlen=MOST_REMARKS)
        self._stopped = threading.Event()
        self._listeners: list[Listener] = []
        self._relay: FlightRelayClient | FlightRelayListener | None = None
        self._threads: list[threading.Thread] = []
        self._states: list[LinkState] = []
        for protocol, port in (listen or {}).items():
            self._try(protocol, f"{LOOPBACK}:{port}", partial(self._listen, DIALECTS[protocol], port))
        if flight_relay is not None:
            where = f"{LOOPBACK}:{flight_relay}" if isinstance(flight_relay, int) else flight_relay
            self._try("flight-relay", where, partial(self._start_relay, flight_relay))
        self._simulators = [_Simulator(each, self.remark) for each in simulators]
        for each in self._simulators:
            self._states.append(LinkState(each.address.protocol, f"simulator on {LOOPBACK}:{each.address.port}", ""))

    @property
    def states(self) -> Sequence[LinkState]:
        """The current state of the connections."""
        waits = isinstance(self._relay, FlightRelayClient) and not self._relay.is_connected
        return [
            each._replace(problem=f"{each.address} is not there yet; trying again")
            if waits and each.protocol == "flight-relay" and not each.problem
            else each
            for each in self._states
        ]

    @property
    def remarks(self) -> Sequence[LiveRemark]:
        """Recent remarks, the oldest first."""
        return tuple(self._remarks)

    def remark(self, text: str) -> None:
        """Add a remark on an event."""
        self._remarks.append(LiveRemark(datetime.now(UTC).isoformat(timespec="seconds"), in_a_line(text)))
        self._on_change()

    def close(self) -> None:
        """End all connections."""
        self._stopped.set()
        for each in self._listeners:
            each.stop()
        for each in self._threads:
            each.join(2.0)
        for each in self._listeners:
            each.close()
        if self._relay is not None:
            self._relay.close()
        for each in self._simulators:
            each.close()

    def _try(self, protocol: str, address: str, start: Callable[[], str]) -> None:
        """Start one connection; record a failure without stopping the others."""
        try:
            self._states.append(LinkState(protocol, start(), ""))
        except LinkError as error:
            self._states.append(LinkState(protocol, address, str(error)))
            self.remark(f"{PROTOCOLS[protocol]}: {error}")

    def _listen(self, dialect: Dialect, port: int) -> str:
        listener = Listener(
            port, dialect=dialect, keep=lambda message: self._keep(message, dialect.name), on_problem=self.remark
        )
        self._listeners.append(listener)
        thread = threading.Thread(target=self._hear, args=(listener,), name=dialect.name, daemon=True)
        self._threads.append(thread)
        thread.start()
        return f"{LOOPBACK}:{listener.port}"

    def _hear(self, listener: Listener) -> None:
        while not self._stopped.is_set():
            try:
                for message in listener.messages():
                    self._remark_ready(message)
            except ClubfaceError as error:  # the shot could not be kept; the monitor gets the error in the answer
                self.remark(str(error))

    def _start_relay(self, where: str | int) -> str:
        def keep(message: Message) -> None:
            try:
                self._keep(message, "flight-relay")
            except ClubfaceError as error:
                self.remark(str(error))

        make = FlightRelayListener if isinstance(where, int) else FlightRelayClient
        self._relay = make(where, keep, self.remark, self._remark_ready)  # pyright: ignore[reportArgumentType]
        return self._relay.address

    def _keep(self, message: Message, protocol: str) -> None:
        shot = self._shots.keep(message, protocol)
        if shot is None:
            self.remark(f"{message.device} sent shot {message.shot_number} again; it is stored already")
            return
        for each in self._simulators:
            each.put(shot)

    def _remark_ready(self, message: Message) -> None:
        if message.kind == "status" and message.is_ready is not None:
            self.remark(f"{message.device} is {'ready' if message.is_ready else 'not ready'}")


class _Simulator:
    """Sends launches to a simulator, one at a time."""

    def __init__(self, address: SimulatorAddress, remark: Callable[[str], object]) -> None:
        self.address, self._remark = address, remark
        self._queue: SimpleQueue[LiveShot] = SimpleQueue()
        self._stopped = threading.Event()
        self._sender: Sender | OpenGolfSimSender | None = None
        self._thread = threading.Thread(target=self._run, name=f"simulator {address.port}", daemon=True)
        self._thread.start()

    def put(self, shot: LiveShot) -> None:
        """Queue the launch of a shot for sending."""
        self._queue.put(shot)

    def close(self) -> None:
        """End the connection."""
        self._stopped.set()
        self._thread.join(2.0)
        self._leave()

    def _run(self) -> None:
        while not self._stopped.is_set():
            try:
                shot = self._queue.get(timeout=WAIT)
            except Empty:
                continue
            try:
                self._remark(f"shot {shot.number}: {self._sent(shot)}")
            except ClubfaceError as error:
                self._leave()
                self._remark(f"shot {shot.number} was not sent to the simulator: {error}")

    def _sent(self, shot: LiveShot) -> str:
        """Send a launch, reconnecting if the connection was lost; return what was sent, in words."""
        every = completed(live_shots([shot]))
        launch = every.launch(0)
        how = "computed from the club data" if "ball_speed" in every.computed_at(0) else "as measured"
        was_connected = self._sender is not None
        try:
            self._send(launch, shot.message)
        except LinkError as error:
            self._leave()
            if not was_connected or error.message.startswith(NO_ANSWER):  # the simulator may have received the shot
                raise
            self._send(launch, shot.message)
        return f"the launch, {how}, was sent to the simulator on port {self.address.port}"

    def _send(self, launch: dict[str, float], message: Message) -> None:
        sender = self._sender = self._sender or SENDERS[self.address.protocol](self.address.port)
        answer = sender.send(launch, message.delivery)
        if answer is not None and not answer.was_taken:
            raise InputError("shot", message.shot_number, f"one that the simulator takes; it says: {answer.message}")

    def _leave(self) -> None:
        if self._sender is not None:
            self._sender.close()
            self._sender = None
