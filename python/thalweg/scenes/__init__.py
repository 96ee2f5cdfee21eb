"""`thalweg new`: a new case from one of the scenes beside this file, each a commented case.toml."""
