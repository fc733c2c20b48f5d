#!/usr/bin/env python3
"""Checks the manifests in deploy/agones: their fields, and that they agree with each other and with the server.

usage: manifests_test.py ROOT BUILD. Each error is a line `file: what`; exit 1 if there is any.

The fields, their types and which must be there were compared with the schemas of github.com/googleforgames/agones at
b19d5fe, which is 1.57.0 in development: install/yaml/install.yaml for Fleet and FleetAutoscaler, and
pkg/apis/allocation/v1/gameserverallocation.go for GameServerAllocation, which has no schema. Those of PodMonitor are from
the documentation of the Prometheus Operator. Of the Pod, only what the manifests use. Image, buffer size and the
specification of a server are optional there, and must be there here.
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

import yaml

FOLDER = "deploy/agones"
RULES = "deploy/monitoring/alerts.yaml"
PAGE = "docs/fleet.md"
# The command of the page that makes a PrometheusRule of the rules.
RULE_COMMAND = re.compile(r"(?m)^ *(\(printf .*alerts\.yaml\)) \| kubectl apply -f -$")
# Besides the drain, the server needs at most this long to stop, seconds (docs/hosting.md).
STOP_SECONDS = 30


class Map:
    """A mapping with these fields, some of which must be there."""

    def __init__(self, fields, required=()):
        self.fields, self.required = fields, required


class Every:
    """A mapping with any keys (`keys` dict) or a list, whose values follow one rule."""

    def __init__(self, kind, rule):
        self.kind, self.rule = kind, rule


class One:
    """One of some texts."""

    def __init__(self, *texts):
        self.texts = texts


LABELS = Every(dict, str)
METADATA = Map({"name": str, "labels": LABELS})
PERCENT = (int, str)
RESOURCES = Map({"cpu": str, "memory": str})
COUNTER = Map({"count": int, "capacity": int})
CONTAINER = Map(
    {
        "name": str, "image": str, "command": Every(list, str), "args": Every(list, str),
        "ports": Every(list, Map({"name": str, "containerPort": int, "protocol": One("TCP", "UDP")}, ("containerPort",))),
        "resources": Map({"requests": RESOURCES, "limits": RESOURCES}),
        "securityContext": Map({"allowPrivilegeEscalation": bool, "readOnlyRootFilesystem": bool, "capabilities": Map({"drop": Every(list, str)})}),
        "volumeMounts": Every(list, Map({"name": str, "mountPath": str, "readOnly": bool}, ("name", "mountPath"))),
    },
    ("name", "image"),
)  # fmt: skip
VOLUME = Map(
    {"name": str, "secret": Map({"secretName": str, "defaultMode": int}), "emptyDir": Map({"medium": str, "sizeLimit": str})},
    ("name",),
)
SECCOMP = Map({"type": One("RuntimeDefault", "Localhost", "Unconfined"), "localhostProfile": str}, ("type",))
POD = Map(
    {
        "terminationGracePeriodSeconds": int,
        "securityContext": Map({"runAsNonRoot": bool, "runAsUser": int, "fsGroup": int, "seccompProfile": SECCOMP}),
        "containers": Every(list, CONTAINER),
        "volumes": Every(list, VOLUME),
    },
    ("containers",),
)
GAME_SERVER = Map(
    {
        "ports": Every(
            list,
            Map({"name": str, "portPolicy": One("Dynamic", "Static", "Passthrough", "None"), "containerPort": int, "protocol": One("UDP", "TCP", "TCPUDP")}),
        ),
        "health": Map({"disabled": bool, "initialDelaySeconds": int, "periodSeconds": int, "failureThreshold": int}),
        "counters": Every(dict, COUNTER),
        "eviction": Map({"safe": One("Always", "OnUpgrade", "Never")}),
        "template": Map({"metadata": Map({"labels": LABELS}), "spec": POD}, ("spec",)),
    },
    ("template",),
)
FLEET = Map(
    {
        "replicas": int,
        "scheduling": One("Packed", "Distributed"),
        "strategy": Map({"type": One("Recreate", "RollingUpdate"), "rollingUpdate": Map({"maxSurge": PERCENT, "maxUnavailable": PERCENT})}),
        "template": Map({"metadata": Map({"labels": LABELS}), "spec": GAME_SERVER}, ("spec",)),
    },
    ("template",),
)
AUTOSCALER = Map(
    {
        "fleetName": str,
        "policy": Map({"type": One("Buffer"), "buffer": Map({"bufferSize": PERCENT, "minReplicas": int, "maxReplicas": int}, ("maxReplicas", "bufferSize"))}, ("type",)),
        "sync": Map({"type": One("FixedInterval"), "fixedInterval": Map({"seconds": int}, ("seconds",))}, ("type",)),
    },
    ("fleetName", "policy"),
)
SELECTOR = Map({"matchLabels": LABELS, "gameServerState": One("Ready", "Allocated"), "counters": Every(dict, Map({"minAvailable": int}))})
ALLOCATION = Map(
    {
        "scheduling": One("Packed", "Distributed"),
        "priorities": Every(list, Map({"type": One("Counter", "List"), "key": str, "order": One("Ascending", "Descending")}, ("type", "key"))),
        "selectors": Every(list, SELECTOR),
        "counters": Every(dict, Map({"action": One("Increment", "Decrement"), "amount": int})),
    }
)
RELABELING = Map({"targetLabel": str, "replacement": str})
ENDPOINT = Map({"port": str, "path": str, "interval": str, "relabelings": Every(list, RELABELING)})
MONITOR = Map({"selector": Map({"matchLabels": LABELS}), "podMetricsEndpoints": Every(list, ENDPOINT)}, ("selector", "podMetricsEndpoints"))
KINDS = {
    "fleet.yaml": ("agones.dev/v1", "Fleet", FLEET),
    "fleet_autoscaler.yaml": ("autoscaling.agones.dev/v1", "FleetAutoscaler", AUTOSCALER),
    "gameserver_allocation.yaml": ("allocation.agones.dev/v1", "GameServerAllocation", ALLOCATION),
    "pod_monitor.yaml": ("monitoring.coreos.com/v1", "PodMonitor", MONITOR),
}


def faults(value, rule, where):
    """What of a value its rule does not allow."""
    if isinstance(rule, Map):
        if not isinstance(value, dict):
            yield f"{where} must be a mapping"
            return
        yield from (f"{where} lacks {name}" for name in rule.required if name not in value)
        for name, part in value.items():
            if name in rule.fields:
                yield from faults(part, rule.fields[name], f"{where}.{name}")
            else:
                yield f"{where}.{name} is no field"
    elif isinstance(rule, Every):
        if not isinstance(value, rule.kind):
            yield f"{where} must be a {rule.kind.__name__}"
            return
        for name, part in value.items() if rule.kind is dict else enumerate(value):
            yield from faults(part, rule.rule, f"{where}.{name}")
    elif isinstance(rule, One):
        if value not in rule.texts:
            yield f"{where} must be one of {', '.join(rule.texts)}"
    elif not isinstance(value, rule) or (rule is int and isinstance(value, bool)):
        yield f"{where} has the wrong type"


def shape_faults(manifests):
    for name, (version, kind, rule) in KINDS.items():
        head = {"apiVersion": One(version), "kind": One(kind), "metadata": METADATA, "spec": rule}
        required = ("apiVersion", "kind", "spec") + (() if kind == "GameServerAllocation" else ("metadata",))
        yield from (f"{name}: {fault}" for fault in faults(manifests[name], Map(head, required), kind))


def options_of(container):
    return dict(argument.removeprefix("--").split("=", 1) for argument in container["args"])


def amount(text, units):
    """A quantity of Kubernetes, such as 20m or 24Mi, in its base unit."""
    number, unit = re.fullmatch(r"(\d+)(\w*)", text).groups()
    return int(number) * units[unit]


def agreement_faults(manifests, constants):
    """What the manifests and the server must have in common."""
    fleet = manifests["fleet.yaml"]
    server = fleet["spec"]["template"]["spec"]
    pod = server["template"]["spec"]
    container = pod["containers"][0]
    options = options_of(container)
    autoscaler = manifests["fleet_autoscaler.yaml"]["spec"]
    allocation = manifests["gameserver_allocation.yaml"]["spec"]
    monitor = manifests["pod_monitor.yaml"]["spec"]
    metrics = {port["name"]: port["containerPort"] for port in container["ports"]}
    health = server["health"]
    mounts = {mount["name"] for mount in container["volumeMounts"]}
    labels = server["template"]["metadata"]["labels"]
    wanted = {
        "the grace period covers the drain": pod["terminationGracePeriodSeconds"] >= int(options["drain"]) + STOP_SECONDS,
        "machines are emptied in less than ten minutes": pod["terminationGracePeriodSeconds"] < 600,
        "the drain covers a round": int(options["drain"]) > constants["kRoundTicks"] / 60 + 60,
        "the port is that of the server": server["ports"][0]["containerPort"] == int(options["port"]),
        "the port is UDP and chosen by Agones": (server["ports"][0]["protocol"], server["ports"][0]["portPolicy"]) == ("UDP", "Dynamic"),
        "the counter holds all players": server["counters"]["players"]["capacity"] == int(options["max-players"]),
        "two pings fit into a period": health["periodSeconds"] >= 2 * constants["kHealthInterval"],
        "the fleet of the autoscaler exists": autoscaler["fleetName"] == fleet["metadata"]["name"],
        "the autoscaler keeps the fleet": autoscaler["policy"]["buffer"]["minReplicas"] <= fleet["spec"]["replicas"] <= autoscaler["policy"]["buffer"]["maxReplicas"],
        "the allocation chooses the fleet": all(one["matchLabels"] == {"agones.dev/fleet": fleet["metadata"]["name"]} for one in allocation["selectors"]),
        "the allocation counts players": set(allocation["counters"]) == set(server["counters"]) == {"players"},
        "the metrics are where they are read": metrics[monitor["podMetricsEndpoints"][0]["port"]] == int(options["metrics"].rsplit(":", 1)[1]),
        "the monitor finds the pods": monitor["selector"]["matchLabels"].items() <= labels.items(),
        "the alerts know the job of the monitor": {"targetLabel": "job", "replacement": constants["job"]} in monitor["podMetricsEndpoints"][0].get("relabelings", []),
        "the system calls are restricted": pod["securityContext"]["seccompProfile"]["type"] == "RuntimeDefault",
        "every volume is mounted": mounts == {volume["name"] for volume in pod["volumes"]},
        "the image is a placeholder": container["image"].startswith("registry.example/"),
        "the processor suffices": amount(container["resources"]["requests"]["cpu"], {"m": 0.1, "": 100}) >= constants["cpu"],
        "the memory suffices": amount(container["resources"]["requests"]["memory"], {"Mi": 1.048576}) >= constants["memory"],
    }  # fmt: skip
    yield from (f"{FOLDER}: it does not hold that {claim}" for claim, holds in wanted.items() if not holds)


def constants_of(root):
    """Numbers of the sources and of the measurement with 16 players on one server."""
    def number(file, pattern):
        return float(re.search(pattern, (root / file).read_text(encoding="utf-8"))[1])

    row = re.search(r"^\| 16 \| perfect \|(.*)$", (root / "docs/netcode.md").read_text(encoding="utf-8"), re.MULTILINE)[1]
    cells = [cell.strip() for cell in row.split("|")]
    return {
        "kRoundTicks": number("shared/include/platon/game/game.h", r"kRoundTicks = (\d+) \* 60") * 60 * 60,
        "kHealthInterval": number("server/fleet/agones_schedule.h", r"kHealthInterval\{(\d+)\}"),
        "job": re.search(r'up\{job="(\w+)"\}', (root / RULES).read_text(encoding="utf-8"))[1],
        "cpu": float(cells[5]),
        "memory": float(cells[6]),
    }


def rule_faults(root):
    """What is wrong with the PrometheusRule that the command of the page makes."""
    command = RULE_COMMAND.search((root / PAGE).read_text(encoding="utf-8"))
    if not command:
        yield f"{PAGE}: there is no command `(printf … {RULES}) | kubectl apply -f -`"
        return
    made = yaml.safe_load(subprocess.run(["sh", "-c", command[1]], cwd=root, stdout=subprocess.PIPE, text=True, check=True).stdout)
    spec = yaml.safe_load((root / RULES).read_text(encoding="utf-8"))
    if made != {"apiVersion": "monitoring.coreos.com/v1", "kind": "PrometheusRule", "metadata": {"name": "platon"}, "spec": spec}:
        yield f"{PAGE}: its command makes no PrometheusRule of {RULES}"


def server_faults(container, program):
    """What the server says to these options, with a key in a folder of this machine."""
    with tempfile.TemporaryDirectory() as folder:
        arguments = [re.sub(r"=(/etc|/run)/platon/", f"={folder}/", argument) for argument in container["args"]]
        checked = subprocess.run([program, "--check-config", *arguments], capture_output=True, text=True)
        if checked.returncode != 0:
            yield f"{FOLDER}/fleet.yaml: {checked.stderr.strip()}"


def main(arguments):
    if len(arguments) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    root, build = map(Path, arguments)
    paths = {path.name: path for path in (root / FOLDER).glob("*.yaml")}
    if paths.keys() != KINDS.keys():
        print(f"{FOLDER}: has {', '.join(sorted(paths))}; wanted are {', '.join(sorted(KINDS))}")
        return 1
    manifests = {name: yaml.safe_load(path.read_text(encoding="utf-8")) for name, path in paths.items()}
    errors = list(shape_faults(manifests))
    if not errors:
        container = manifests["fleet.yaml"]["spec"]["template"]["spec"]["template"]["spec"]["containers"][0]
        errors = [*agreement_faults(manifests, constants_of(root)), *rule_faults(root), *server_faults(container, build / "bin/platon-server")]
    for error in errors:
        print(error)
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
