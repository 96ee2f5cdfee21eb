"""Case definitions of other programs as case.toml: DualSPHysics' GenCase (docs/import.md)."""
