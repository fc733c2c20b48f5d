#!/usr/bin/env python3
"""Tests that manifests_test.py finds errors in the manifests.

usage: manifests_self_test.py ROOT
"""

import copy
import sys
import unittest
from pathlib import Path

import manifests_test
import yaml

ROOT = Path(sys.argv.pop(1)) if len(sys.argv) > 1 else Path(".")
MANIFESTS = {name: yaml.safe_load((ROOT / manifests_test.FOLDER / name).read_text(encoding="utf-8")) for name in manifests_test.KINDS}
CONSTANTS = manifests_test.constants_of(ROOT)


def server_of(manifests):
    return manifests["fleet.yaml"]["spec"]["template"]["spec"]


class Manifests(unittest.TestCase):
    def setUp(self):
        self.manifests = copy.deepcopy(MANIFESTS)

    def shapes(self):
        return list(manifests_test.shape_faults(self.manifests))

    def claims(self):
        return [fault.split("hold that ")[1] for fault in manifests_test.agreement_faults(self.manifests, CONSTANTS)]

    def test_they_are_right(self):
        self.assertEqual(self.shapes() + self.claims(), [])

    def test_an_unknown_field_is_an_error(self):
        server_of(self.manifests)["healt"] = {}
        self.assertEqual(self.shapes(), ["fleet.yaml: Fleet.spec.template.spec.healt is no field"])

    def test_a_missing_field_is_an_error(self):
        del self.manifests["fleet_autoscaler.yaml"]["spec"]["fleetName"]
        self.assertEqual(self.shapes(), ["fleet_autoscaler.yaml: FleetAutoscaler.spec lacks fleetName"])

    def test_a_wrong_type_is_an_error(self):
        server_of(self.manifests)["health"]["periodSeconds"] = "5"
        server_of(self.manifests)["ports"][0]["protocol"] = "udp"
        self.manifests["fleet.yaml"]["spec"]["replicas"] = True
        self.assertEqual(len(self.shapes()), 3)

    def test_a_field_that_agones_requires_is_missed(self):
        del server_of(self.manifests)["template"]["spec"]["containers"][0]["name"]
        self.assertEqual(self.shapes(), ["fleet.yaml: Fleet.spec.template.spec.template.spec.containers[] lacks name"])

    def test_another_kind_is_an_error(self):
        self.manifests["fleet.yaml"]["apiVersion"] = "agones.dev/v2"
        self.assertEqual(self.shapes(), ["fleet.yaml: must be Fleet of agones.dev/v1"])

    def test_an_allocation_of_any_release_is_an_error(self):
        """An update refilled old servers for ever."""
        for selector in self.manifests["gameserver_allocation.yaml"]["spec"]["selectors"]:
            with self.subTest(selector["gameServerState"]):
                release = selector["matchLabels"].pop(manifests_test.RELEASE)
                self.assertEqual(self.claims(), ["the allocation chooses the release"])
                selector["matchLabels"][manifests_test.RELEASE] = release

    def test_servers_without_the_label_of_their_release_are_an_error(self):
        del self.manifests["fleet.yaml"]["spec"]["template"]["metadata"]["labels"][manifests_test.RELEASE]
        self.assertIn("the release is that of this tree", self.claims())

    def test_a_short_grace_period_is_an_error(self):
        server_of(self.manifests)["template"]["spec"]["terminationGracePeriodSeconds"] = 569
        self.assertEqual(self.claims(), ["the grace period covers the drain"])

    def test_too_few_resources_are_errors(self):
        server_of(self.manifests)["template"]["spec"]["containers"][0]["resources"]["requests"] = {"cpu": "14m", "memory": "9Mi"}
        self.assertEqual(self.claims(), ["the processor suffices", "the memory suffices"])


if __name__ == "__main__":
    unittest.main()
