"""Bridges to libraries that train and evaluate agents. Each module needs its library, and nothing else needs the modules.

    unietp.integrations.verifiers   verifiers      a taskset and a multi-turn environment
    unietp.integrations.inspect     Inspect AI     a task whose solver acts through tools
    unietp.integrations.openenv     OpenEnv        a server with sessions over WebSocket, and its client
    unietp.integrations.trl         TRL            an environment for GRPOTrainer
"""
