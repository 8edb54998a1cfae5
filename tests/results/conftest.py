"""What tests of results share."""

import base64
import re

import pytest


@pytest.fixture
def saved_tables():
    """Read the CSV files that a report in HTML lets a reader save, by their names."""

    def read(path):
        links = re.findall(r'<a download="([^"]+\.csv)" href="data:text/csv;base64,([^"]+)"', path.read_text())
        return {name: base64.b64decode(text).decode() for name, text in links}

    return read
