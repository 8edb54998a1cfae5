"""Nobody but a page of the studio, with the token of its address, is answered."""

import pytest

pytest.importorskip("starlette")

from clubface.studio.serve import new_token
from studio_pages import HOST, TOKEN, client


@pytest.fixture
def studio(tmp_path):
    return client(tmp_path)


def test_the_page_and_its_questions_are_answered(studio):
    page = studio.get("")
    assert page.status_code == 200
    assert '<head><meta name="clubface-api" content="api/">' in page.text
    assert page.headers["referrer-policy"] == "no-referrer"
    assert "frame-ancestors 'self'" in page.headers["content-security-policy"]
    offers = studio.get("api/", headers={"Origin": f"http://{HOST}", "Sec-Fetch-Site": "same-origin"})
    assert (offers.status_code, offers.json()["live"]) == (200, False)
    assert studio.get("api/", headers={"Host": "localhost:9000", "Origin": "http://localhost:9000"}).status_code == 200


@pytest.mark.parametrize("path", ["", "assets/a.js", "api/", "api/live/events"])
@pytest.mark.parametrize("token", ["", "wrong", TOKEN[:-1], TOKEN + "x", TOKEN.upper(), "%00", "..", "\u20ac"])
def test_without_the_token_nothing_is_answered(studio, path, token):
    answer = studio.get(f"http://{HOST}/{token}/{path}" if token else f"http://{HOST}/{path}")
    assert answer.status_code == 403
    assert answer.json() == {"where": "address", "what": "open the whole address that clubface studio printed",
                             "allowed": None}  # fmt: skip


@pytest.mark.parametrize(
    "host",
    ["evil.example", "evil.example:8642", "127.0.0.1.evil.example:8642", "localhost.evil.example", "192.168.1.5:8642",
     "127.0.0.1:", "127.0.0.1:8642:1", "127.0.0.1:x", "", "[::1]:8642", "0.0.0.0:8642", "LOCALHOST@evil:1"],
)  # fmt: skip
def test_a_name_that_leads_here_by_dns_rebinding_is_refused(studio, host):
    answer = studio.get("api/", headers={"Host": host})
    if host == "127.0.0.1:":
        assert answer.status_code == 200  # the usual port, as nothing stands behind the colon
    else:
        assert (answer.status_code, answer.json()["where"]) == (421, "Host")


ORIGINS = (
    "http://evil.example", "null", "", "https://127.0.0.1:8642", "http://127.0.0.1:8643", "http://127.0.0.1",
    "http://localhost:8642", "http://127.0.0.1:8642.evil.example", "file://",
)  # fmt: skip


@pytest.mark.parametrize(
    ("header", "value"),
    [
        *(("Origin", each) for each in ORIGINS),
        *(("Sec-Fetch-Site", each) for each in ("cross-site", "same-site", "", "anything")),
    ],
)
@pytest.mark.parametrize("method", ["GET", "POST", "DELETE"])
def test_a_page_of_another_site_is_refused_though_it_knows_the_token(studio, header, value, method):
    answer = studio.request(method, "api/files", headers={header: value}, content=b"x")
    assert (answer.status_code, answer.json()["where"]) == (403, header)


def test_the_address_without_its_last_slash_redirects(studio):
    answer = studio.get(f"http://{HOST}/{TOKEN}")
    assert (answer.status_code, answer.headers["location"]) == (307, f"/{TOKEN}/")


def test_tokens_are_long_and_differ():
    tokens = {new_token() for _ in range(100)}
    assert len(tokens) == 100
    assert min(map(len, tokens)) >= 32


@pytest.mark.parametrize("path", ["../secret", "%2e%2e/secret", "assets/../../secret", "/etc/passwd", "assets", "sw.js",
                                  "assets/..%2f..%2fsecret", "nothing.js"])  # fmt: skip
def test_no_file_outside_the_site_is_served(tmp_path, path):
    (tmp_path / "secret").write_text("secret")
    studio = client(tmp_path / "site")
    answer = studio.get(f"http://{HOST}/{TOKEN}/{path}")
    assert answer.status_code in (403, 404)
    assert "secret" not in answer.text.replace("/secret", "")


@pytest.mark.parametrize(("method", "path"), [("GET", "api/nothing"), ("PUT", "api/files"), ("DELETE", "api/files/x"),
                                              ("POST", "api/"), ("GET", "api/files/x/y/z")])  # fmt: skip
def test_a_missing_resource_is_a_json_answer(studio, method, path):
    answer = studio.request(method, path)
    assert answer.status_code in (404, 405)
    assert set(answer.json()) == {"where", "what", "allowed"}
