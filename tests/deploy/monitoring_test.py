#!/usr/bin/env python3
"""Checks deploy/monitoring against the metrics of a server that runs: every metric and label that the alert rules and
the dashboard name is one that the server writes, and promtool of Prometheus accepts what it writes.

usage: monitoring_test.py ROOT BUILD
"""

import json
import re
import socket
import subprocess
import sys
import tempfile
import unittest
import urllib.request
from pathlib import Path

import yaml

ROOT, BUILD = (Path(argument).resolve() for argument in sys.argv[1:3])
FOLDER = ROOT / "deploy/monitoring"
SAMPLE = re.compile(r'^(\w+)(?:\{(.*)\})? \S+$', re.MULTILINE)
LABEL = re.compile(r'(\w+)="((?:[^"\\]|\\.)*)"')
SELECTOR = re.compile(r'\b((?:platon|process)_\w+)(?:\{([^}]*)\})?')
MATCHER = re.compile(r'(\w+)(=~|=)"([^"]*)"')
# Prometheus adds these to every sample.
ADDED = ("instance", "job")
# What no alert watches.
QUIET = {"platon_info", "platon_bans", "platon_tick_seconds_sum", "platon_tick_seconds_count", "platon_received_bytes_total", "platon_sent_bytes_total"}
# Ports of Prometheus and its exporters (github.com/prometheus/prometheus/wiki/Default-port-allocations), and those that
# Linux gives to outgoing connections.
PORTS_OF_OTHERS = (range(9090, 11000), range(32768, 61000))


def metrics_of_a_server():
    """What a server answers."""
    with tempfile.TemporaryDirectory(dir="/tmp") as folder:  # the path of a socket must be short
        options = ["--bind", "127.0.0.1", "--port", "0", "--metrics", "127.0.0.1:0", "--socket", f"{folder}/socket", "--key-file", f"{folder}/key"]
        with subprocess.Popen([BUILD / "bin/platon-server", *options], stderr=subprocess.PIPE, text=True) as server:
            try:
                address = next(found[1] for line in server.stderr if (found := re.search(r"metrics on (\S+)", line)))
                with urllib.request.urlopen(f"http://{address}/metrics", timeout=60) as answer:
                    return answer.read().decode()
            finally:
                server.terminate()


def samples_of(text):
    """The names of the samples, each with the values of its labels."""
    samples = {}
    for name, labels in SAMPLE.findall(text):
        for label, value in LABEL.findall(labels):
            samples.setdefault(name, {}).setdefault(label, set()).add(value)
        samples.setdefault(name, {})
    return samples


TEXT = metrics_of_a_server()
METRICS = samples_of(TEXT)
RULES = yaml.safe_load((FOLDER / "alerts.yaml").read_text(encoding="utf-8"))["groups"][0]["rules"]
DASHBOARD = json.loads((FOLDER / "platon.json").read_text(encoding="utf-8"))
PANELS = DASHBOARD["panels"]


def faults_of(expression):
    """What an expression names that no server writes."""
    for name, matchers in SELECTOR.findall(expression):
        if name not in METRICS:
            yield f"no metric {name}"
            continue
        for label, operator, value in MATCHER.findall(matchers):
            if label in ADDED:
                continue
            values = set(value.split("|") if operator == "=~" else [value])
            if not values <= METRICS[name].get(label, set()):
                yield f"{name} never has {label}={value}"


class Monitoring(unittest.TestCase):
    def test_the_server_writes_metrics(self):
        self.assertEqual(METRICS["platon_players"], {"state": {"connected", "disconnected"}})
        self.assertGreater(len(METRICS), 10)

    def test_promtool_accepts_the_metrics(self):
        result = subprocess.run(["promtool", "check", "metrics"], input=TEXT, capture_output=True, text=True, check=False)
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))

    def test_every_metric_has_an_alert_or_needs_none(self):
        watched = {name for rule in RULES for name, _ in SELECTOR.findall(rule["expr"])}
        self.assertEqual(set(METRICS) - watched, QUIET, "give a metric that no alert uses an alert in alerts.yaml, or name it in QUIET")

    def test_the_port_of_the_metrics_is_one_that_nobody_else_uses(self):
        default = re.search(r'^place\(metrics "" 127\.0\.0\.1:(\d+)\)$', (ROOT / "deploy/describe/server_config.cmake").read_text(encoding="utf-8"), re.MULTILINE)
        port = int(default[1])
        self.assertFalse(any(port in ports for ports in PORTS_OF_OTHERS))
        with self.assertRaises(OSError, msg="the list of services of this machine has it"):
            socket.getservbyport(port)
        for name in ("deploy/agones/fleet.yaml", "docs/hosting.md", "docs/fleet.md"):
            found = set(re.findall(r"(?:metrics=0\.0\.0\.0:|127\.0\.0\.1:|metrics 0\.0\.0\.0:|TCP port )(\d+)\b", (ROOT / name).read_text(encoding="utf-8")))
            self.assertEqual(found & {str(port), "9100"}, {str(port)}, name)

    def test_what_no_server_writes_is_found(self):
        self.assertEqual(list(faults_of("rate(platon_ticks_total[5m])")), ["no metric platon_ticks_total"])
        self.assertEqual(list(faults_of('platon_players{state="away"} + platon_bans{instance="a"}')), ["platon_players never has state=away"])

    def test_the_rules_name_what_servers_write(self):
        for rule in RULES:
            self.assertEqual(list(faults_of(rule["expr"])), [], rule["alert"])
            self.assertTrue({"summary", "description"} <= rule["annotations"].keys(), rule["alert"])

    def test_the_dashboard_names_what_servers_write(self):
        for panel in PANELS:
            self.assertTrue(panel["description"], panel["title"])
            for target in panel["targets"]:
                self.assertEqual(list(faults_of(target["expr"])), [], panel["title"])
                self.assertIn('instance=~"$instance"', target["expr"], panel["title"])

    def test_every_metric_is_on_the_dashboard(self):
        shown = " ".join(target["expr"] for panel in PANELS for target in panel["targets"])
        missing = [name for name in METRICS if name not in shown and name != "platon_tick_seconds_count"]
        self.assertEqual(missing, [], "add a panel with these to deploy/monitoring/platon.json")

    def test_no_panel_covers_another(self):
        cells = [(x, y) for place in (panel["gridPos"] for panel in PANELS) for x in range(place["x"], place["x"] + place["w"]) for y in range(place["y"], place["y"] + place["h"])]
        self.assertEqual(len(cells), len(set(cells)))
        self.assertLess(max(x for x, _ in cells), 24)
        self.assertEqual(len({panel["id"] for panel in PANELS}), len(PANELS))

    def test_the_page_names_every_alert(self):
        page = (ROOT / "docs/hosting.md").read_text(encoding="utf-8")
        self.assertEqual([rule["alert"] for rule in RULES if f"`{rule['alert']}`" not in page], [])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
