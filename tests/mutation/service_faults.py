"""Faults in what the server tells systemd."""

from fault import at_length

MANAGER = "server/service/service_manager.cpp"

SERVICE_FAULTS = [
    at_length("one-sign-of-life-in-a-period", MANAGER,
              "numberOf(environment.watchdogMicroseconds) / 2", "numberOf(environment.watchdogMicroseconds)",
              "systemd may restart a server whose ticks go on",
              "ServiceManagerTest.ASignOfLifeIsGivenTwiceInAPeriod"),
    at_length("watchdog-of-another-process", MANAGER,
              "numberOf(environment.watchdogProcess) == environment.process", "numberOf(environment.watchdogProcess) != 0",
              "a server answers a watchdog that waits for another process",
              "ServiceManagerTest.NoWatchdogWaitsWithoutAPeriodOrForAnotherProcess"),
]  # fmt: skip
