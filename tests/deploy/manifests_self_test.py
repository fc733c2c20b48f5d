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

    def test_another_kind_is_an_error(self):
        self.manifests["fleet.yaml"]["apiVersion"] = "agones.dev/v2"
        self.assertEqual(self.shapes(), ["fleet.yaml: Fleet.apiVersion must be one of agones.dev/v1"])

    def test_a_short_grace_period_is_an_error(self):
        server_of(self.manifests)["template"]["spec"]["terminationGracePeriodSeconds"] = 569
        self.assertEqual(self.claims(), ["the grace period covers the drain"])

    def test_another_port_is_an_error(self):
        server_of(self.manifests)["ports"][0]["containerPort"] = 7778
        self.assertEqual(self.claims(), ["the port is that of the server"])

    def test_another_job_is_an_error(self):
        endpoint = self.manifests["pod_monitor.yaml"]["spec"]["podMetricsEndpoints"][0]
        endpoint["relabelings"][0]["replacement"] = "other"
        self.assertEqual(self.claims(), ["the alerts know the job of the monitor"])
        del endpoint["relabelings"]
        self.assertEqual(self.claims(), ["the alerts know the job of the monitor"])

    def test_free_system_calls_are_an_error(self):
        server_of(self.manifests)["template"]["spec"]["securityContext"]["seccompProfile"]["type"] = "Unconfined"
        self.assertEqual(self.claims(), ["the system calls are restricted"])

    def test_another_name_is_an_error(self):
        self.manifests["fleet.yaml"]["metadata"]["name"] = "other"
        self.assertEqual(self.claims(), ["the fleet of the autoscaler exists", "the allocation chooses the fleet"])

    def test_too_few_resources_are_errors(self):
        server_of(self.manifests)["template"]["spec"]["containers"][0]["resources"]["requests"] = {"cpu": "14m", "memory": "9Mi"}
        self.assertEqual(self.claims(), ["the processor suffices", "the memory suffices"])


if __name__ == "__main__":
    unittest.main()
