"""Runs a policy class for `unietp evaluate --policy python:module.Class`: reads calls from standard input, one a line,
and answers each on standard output. What the policy prints goes to standard error."""
import importlib
import json
import os
import sys


def main(name):
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)  # so that a print in the policy does not break the protocol
    sys.path.insert(0, os.getcwd())
    module, _, of_class = name.rpartition(".")
    try:
        policy_class = getattr(importlib.import_module(module), of_class)
    except (ImportError, AttributeError) as error:
        sys.exit(f"cannot load {name}: {error}")
    policy = policy_class()
    for line in sys.stdin:
        call = json.loads(line)
        params = call["params"]
        if call["method"] == "begin" and hasattr(policy, "begin"):
            policy.begin({key: params[key] for key in ("task", "mode", "repeat", "seed", "prompt")})
        observation = dict(params["observation"], text=params["text"])
        if "picture" in params:
            observation["picture"] = params["picture"]
        result = {"action": policy.act(observation)}
        print(json.dumps({"jsonrpc": "2.0", "id": call["id"], "result": result}), file=answers, flush=True)


main(sys.argv[1])
