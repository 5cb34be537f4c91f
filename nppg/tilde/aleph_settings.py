"""Names of Aleph: its parameters and directives."""

from __future__ import annotations

TREE = ("classes", "confidence", "dependent", "evalfn", "lookahead", "minpos", "prune_tree", "tree_type")  # of trees

_DIRECTIVES = """
aleph aleph_read_all commutative cost_template example_weight initialization lazy_evaluate noreductive positive_only
read_all symmetric use_rendering
"""
_PARAMETERS = """
abduce best cache_clauselength caching caching_clauses check_good check_redundant check_useless clauselength
clauselength_distribution clauses condition construct_bottom depth explore good goodfile
gsamplesize i interactive language lazy_bottom lazy_negs lazy_on_contradiction lazy_on_cost max_abducibles
max_features minacc mincover mingain minposfrac minscore moves newvars nodes noise nreduce_bottom openlist
optimise_clauses permute_bottom portray_examples portray_hypothesis portray_literals portray_search print
proof_strategy prooftime prune_defs record recordfile refine refineop resample rls_type rulefile
samplesize scs_percentile scs_prob scs_sample scs_type search searchtime skolemvars splitvars stage store_bottom
store_cover stream subsample subsamplesize temperature test_neg test_pos threads train_neg train_pos tries
typeoverlap uniform_sample updateback verbose verbosity version walk
"""
SILENT = frozenset(_DIRECTIVES.split())  # directives of no meaning for a tree
SEARCH = frozenset(_PARAMETERS.split())  # parameters of the search for clauses, which a tree does not make
