"""Relational Q-learning (RRL) with the incremental regressors TG, RIB and TRENDI."""
