#!/usr/bin/env python3
"""Checks the manifests in deploy/agones: their fields, and that they agree with each other and with the server.

usage: manifests_test.py ROOT BUILD. Each error is a line `file: what`; exit 1 if there is any.

agones_fields.txt has the fields, their types and which must be there, and names its sources.
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
# The label of a server that tells its release: an update that does not change it would send players to old servers for ever.
RELEASE = "app.kubernetes.io/version"
# Besides the drain, the server needs at most this long to stop, seconds (docs/hosting.md).
STOP_SECONDS = 30


# What the checks below look at must be there, also where the source lets it away.
NEEDED = {
    "Fleet": ("metadata", "spec"),
    "FleetAutoscaler": ("metadata", "spec"),
    "FleetAutoscaler.spec.policy.buffer": ("bufferSize", "minReplicas"),
    "Fleet.spec.template.spec.template.spec.containers[]": ("image", "args"),
}
KINDS = {
    "fleet.yaml": ("agones.dev/v1", "Fleet"),
    "fleet_autoscaler.yaml": ("autoscaling.agones.dev/v1", "FleetAutoscaler"),
    "gameserver_allocation.yaml": ("allocation.agones.dev/v1", "GameServerAllocation"),
    "pod_monitor.yaml": ("monitoring.coreos.com/v1", "PodMonitor"),
}
TYPES = {"string": str, "integer": int, "boolean": bool, "object": dict, "map": dict, "list": list, "int-or-string": (int, str)}


def fields_of(text):
    """For each path of the file: the types of the fields of this object by their names, or the type of an element."""
    lines = (line.split() for line in text.splitlines() if not line.startswith("#"))
    return {path: words[0] if ":" not in words[0] else dict(word.split(":") for word in words) for path, *words in lines}


FIELDS = fields_of(Path(__file__).with_name("agones_fields.txt").read_text(encoding="utf-8"))


def has_type(value, kind):
    if kind not in TYPES:
        return value in kind.split("|")
    return isinstance(value, TYPES[kind]) and isinstance(value, bool) == (kind == "boolean")


def faults(value, kind, path):
    """What of a value of this type the fields do not allow."""
    if not has_type(value, kind):
        yield f"{path} must be {kind}"
    elif kind == "object":
        yield from object_faults(value, path)
    elif kind in ("map", "list"):
        element = path + ("{}" if kind == "map" else "[]")
        inner = FIELDS.get(element)
        for part in value.values() if kind == "map" else value:
            yield from faults(part, inner if isinstance(inner, str) else "object", element)


def object_faults(value, path):
    fields = FIELDS.get(path, {})
    kinds = {name.removesuffix("!"): kind for name, kind in fields.items()}
    required = {name[:-1] for name in fields if name.endswith("!")} | set(NEEDED.get(path, ()))
    yield from (f"{path} lacks {name}" for name in sorted(required - value.keys()))
    for name, part in value.items():
        if name in kinds:
            yield from faults(part, kinds[name], f"{path}.{name}")
        else:
            yield f"{path}.{name} is no field"


def shape_faults(manifests):
    for name, (version, kind) in KINDS.items():
        manifest = manifests[name]
        if (manifest.get("apiVersion"), manifest.get("kind")) != (version, kind):
            yield f"{name}: must be {kind} of {version}"
        yield from (f"{name}: {fault}" for fault in faults(manifest, "object", kind))


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
    release = fleet["spec"]["template"]["metadata"]["labels"].get(RELEASE)
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
        "the allocation chooses the fleet": all(one["matchLabels"].get("agones.dev/fleet") == fleet["metadata"]["name"] for one in allocation["selectors"]),
        "the allocation chooses the release": all(one["matchLabels"].get(RELEASE) == release for one in allocation["selectors"]),
        "the release is that of this tree": release == constants["version"],
        "the image is of the release": container["image"].endswith(f":{release}"),
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
        "kHealthInterval": number("server/fleet/agones_reporter.h", r"kHealthInterval\{(\d+)\}"),
        "job": re.search(r'up\{job="(\w+)"\}', (root / RULES).read_text(encoding="utf-8"))[1],
        "version": re.search(r"project\(platon VERSION ([0-9.]+)", (root / "CMakeLists.txt").read_text(encoding="utf-8"))[1],
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
