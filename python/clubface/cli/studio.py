"""``clubface studio``: the studio in the browser, with the files, studies and live shots of this machine."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from clubface.cli import options, output
from clubface.cli.failures import print_note
from clubface.errors import InputError
from clubface.support.sockets import check_port

if TYPE_CHECKING:
    from clubface.studio.live import LiveSession

FLIGHT_RELAY = "ws://localhost:5880/frp"
app = typer.Typer(add_completion=False)


@app.command()
@options.takes(
    options.group(None,
        port=(int, 8642, "NUMBER", "Port on this machine; 0 picks a free one."),
        studies=(str | None, None, "FOLDER", "Also show the study stores in this folder."),
        open=(bool, False, None, "Open it in the browser."),
        site=(str | None, None, "FOLDER", "Folder with another built studio."),
    ),
    options.group("Live shots",
        live=(str | None, None, "FILE", "Receive live shots from launch monitors, and keep them in this file."),
        open_connect=(int, 921, "PORT", "Port for monitors that use GSPro Open Connect."),
        opengolfsim=(int, 3111, "PORT", "Port for monitors that use OpenGolfSim."),
        flight_relay=(str, FLIGHT_RELAY, "ADDRESS|PORT", "A Flight Relay device, or the port it connects to."),
        simulator=(options.Texts, None, "NAME:PORT", "Forward launches to open-connect:PORT or opengolfsim:PORT."),
    ),
)  # fmt: skip
def studio(**texts: Any) -> None:
    """Serve the studio on this machine: monitor files, golfers, fittings, studies, live shots."""
    from clubface.shots.live_links import simulator_address
    from clubface.studio.serve import serve

    live, studies = texts["live"], texts["studies"]
    for name in ("port", "open_connect", "opengolfsim"):
        check_port(texts[name], 0, f"--{name.replace('_', '-')}")
    if (relay := texts["flight_relay"]).isdecimal():
        check_port(relay := int(relay), 0, "--flight-relay")
    if studies is not None and not Path(studies).is_dir():
        raise InputError("--studies", studies, "a folder")
    if live is None and texts["simulator"]:
        raise InputError("--simulator", texts["simulator"][0], "leave it out without --live")
    if live is not None:
        output.check_target("--live", live, (".jsonl",))
    links = {
        "listen": {"open-connect": texts["open_connect"], "opengolfsim": texts["opengolfsim"]},
        "flight_relay": relay,
        "simulators": [simulator_address(each) for each in texts["simulator"] or ()],
    }

    sessions: list[LiveSession] = []

    def on_start(address: str, session: LiveSession | None) -> None:
        sessions.extend([] if session is None else [session])
        for each in [] if session is None else session.links.states:
            print_note(f"{each.protocol}: {each.problem or each.address}")
        print(address, flush=True)
        print_note("open this address in a browser; Ctrl-C ends")
        if texts["open"]:
            import webbrowser

            webbrowser.open(address)

    try:
        serve(
            port=texts["port"], site=texts["site"], studies=studies, live=live, on_start=on_start,
            **({} if live is None else links),
        )  # fmt: skip
    except KeyboardInterrupt:
        counts = [len(each.shots.shots) for each in sessions]
        kept = [f"{count} live shot{'s' * (count != 1)} in {live}" for count in counts]
        raise KeyboardInterrupt(*kept) from None
