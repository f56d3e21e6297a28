#!/usr/bin/python3
"""Requests to a workbench, as its page sends them.

    bench_request.py ADDRESS NAME [JSON] [HEADER:VALUE...]    prints the answer; ends with 1 unless the status is 200, which
                                                              is then printed; NAME may be a whole path that begins with /
    bench_request.py ADDRESS alive SECONDS                    keeps a page open
"""
import contextlib
import http.client
import sys
import time
import urllib.parse


def answer_to(address, name, body, headers):
    """Status and text."""
    url = urllib.parse.urlsplit(address)
    path = name if name.startswith("/") else url.path + name
    with contextlib.closing(http.client.HTTPConnection(url.hostname, url.port, timeout=300)) as connection:
        kind = {"Content-Type": "application/json"} if body is not None else {}
        connection.request("GET" if body is None else "POST", path, body, kind | headers)
        answer = connection.getresponse()
        return answer.status, answer.read().decode()


def main():
    address, name, *rest = sys.argv[1:]
    if name == "alive":
        url = urllib.parse.urlsplit(address)
        connection = http.client.HTTPConnection(url.hostname, url.port)
        connection.request("GET", url.path + name)
        connection.getresponse().read(1)
        time.sleep(float(rest[0]))
        return
    headers = dict(word.split(":", 1) for word in rest if word[0] != "{")
    body = next((word for word in rest if word[0] == "{"), None)
    status, text = answer_to(address, name, body, headers)
    print(text if status == 200 else status)
    sys.exit(status != 200)


main()
