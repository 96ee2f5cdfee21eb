"""`thalweg validate` and `thalweg sweep`: runs measured against nature, and over a range of keys (ARCHITECTURE.md, "Validation")."""
