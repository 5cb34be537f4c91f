:- module(nppg_allowed,
          [ kind/2,              % +Head, -Kind                  det
            importable/1,        % +Library                      semidet
            exists/1,            % +Head                         semidet
            library_of/2,        % +Indicator, -Library          semidet
            safe_library/1,      % ?Library                      nondet
            safe_directive/1     % +Directive                    semidet
          ]).


:- use_module(library(dcg/basics), []).
:- use_module(library(dcg/high_order), []).
:- use_module(library(lists), [member/2]).

/** <module> What a domain may call that is not trusted

All else is refused: what is not in a list here, or exported by one of the libraries here.
*/

:- dynamic known_kind/3.         % Name, Arity, Kind

%!  kind(+Head, -Kind) is det.
%
%   What a predicate that the file does not define is to a domain: `pure`; meta(Spec), which calls goals among its
%   arguments; special(What), which depends on its arguments; `other`, which is not allowed, or unknown.

kind(Head, Kind) :-
    functor(Head, Name, Arity),
    (   known_kind(Name, Arity, Known)
    ->  Kind = Known
    ;   once(found_kind(Name/Arity, Kind)),
        assertz(known_kind(Name, Arity, Kind))
    ).

found_kind(Indicator, special(What)) :-
    special(What, Indicators),
    memberchk(Indicator, Indicators).
found_kind(Indicator, Kind) :-
    built_in(Indicators),
    memberchk(Indicator, Indicators),
    of_spec(Indicator, Kind).
found_kind(Name/Arity, Kind) :-
    library_of(Name/Arity, _),
    \+ memberchk(Name/Arity, [arithmetic_expression_value/2, arithmetic_function/1, setrand/1, dict_options/2]),
    of_spec(Name/Arity, Kind).
found_kind(_, other).

%   Asked in a module of its own: into that of a domain nothing is to be imported by asking.

of_spec(Name/Arity, Kind) :-
    functor(Head, Name, Arity),
    (   grammar_library(_, Module),
        predicate_property(Module:Head, exported)
    ->  true
    ;   Module = nppg_allowed_sight
    ),
    (   predicate_property(Module:Head, meta_predicate(Spec)),
        arg(_, Spec, Argument),
        ( integer(Argument) ; memberchk(Argument, [^, //]) )
    ->  Kind = meta(Spec)
    ;   Kind = pure
    ).

%!  exists(+Head) is semidet.
%
%   Succeeds where Prolog has the predicate, or would load it when it is called.

exists(Head) :-
    functor(Head, Name, Arity),
    (   member(Module, [system, nppg_randomness, nppg_formula]),
        predicate_property(Module:Head, defined)
    ;   predicate_property(user:Head, visible)
    ;   '$in_library'(Name, Arity, _)
    ),
    !.

%!  library_of(+Indicator, -Library) is semidet.
%
%   The library among those that are allowed from which Prolog would load the predicate.

library_of(Name/Arity, Library) :-
    (   '$in_library'(Name, Arity, Path),
        safe_library(Library),
        atom_concat('/library/', Library, End),
        sub_atom(Path, _, _, 0, End)
    ;   functor(Head, Name, Arity),
        grammar_library(Library, Module),
        predicate_property(Module:Head, exported)
    ),
    !.

%   Libraries that Prolog does not load by itself.

grammar_library('dcg/basics', dcg_basics).
grammar_library('dcg/high_order', dcg_high_order).

safe_library(lists).
safe_library(apply).
safe_library(aggregate).
safe_library(assoc).
safe_library(ordsets).
safe_library(pairs).
safe_library(solution_sequences).
safe_library(ugraphs).
safe_library(rbtrees).
safe_library(heaps).
safe_library(nb_set).
safe_library(option).
safe_library(error).
safe_library(occurs).
safe_library(terms).
safe_library(tabling).
safe_library(random).
safe_library(arithmetic).
safe_library('dcg/basics').
safe_library('dcg/high_order').

%!  importable(+Library) is semidet.
%
%   Libraries that a file may import; a lambda expression is looked at where it is called, see goals.pl.

importable(Library) :-
    safe_library(Library).
importable(yall).

%!  safe_directive(+Directive) is semidet.
%
%   What may be told to Prolog about the file, beside what safety.pl looks into.

safe_directive(set_prolog_flag(double_quotes, Value)) :-
    memberchk(Value, [codes, chars, atom, string]).
safe_directive(style_check(Style)) :-
    ground(Style),
    memberchk(Style, [-singleton, +singleton, -discontiguous, +discontiguous, -no_effect, -var_branches, +var_branches]).
safe_directive(encoding(utf8)).
safe_directive(license(Name)) :-
    atom(Name).

%   Depend on their arguments: see goals.pl.

special(clauses, [assert/1, asserta/1, assertz/1, retract/1, retractall/1, clause/2]).
special(key, [nb_setval/2, b_setval/2, nb_getval/2, b_getval/2]).
special(format, [format/1, format/2, format/3]).
special(stream, [write/2, writeln/2, writeq/2, print/2, nl/1, tab/2, write_canonical/2]).
special(text, [term_to_atom/2, term_string/2, atom_to_term/3, read_term_from_atom/3]).
special(options, [write_term/2]).
special(phrase, [phrase/2, phrase/3]).
special(digits, [atom_number/2, number_codes/2, number_chars/2, number_string/2, name/2]).
special(width, [tab/1]).
special(arithmetic, [(is)/2, (=:=)/2, (=\\=)/2, (<)/2, (>)/2, (=<)/2, (>=)/2]).

built_in([ true/0, fail/0, false/0, repeat/0, !/0, (\+)/1, not/1, once/1, ignore/1, call/1, call/2, call/3, call/4, call/5,
           call/6, call/7, call/8, forall/2, findall/3, findall/4, bagof/3, setof/3, catch/3, findnsols/4, call_cleanup/2,
           setup_call_cleanup/3, setup_call_catcher_cleanup/4, with_output_to/2, freeze/2, dif/2, when/2, throw/1,
           abort/0, (=)/2, (\=)/2, (==)/2, (\==)/2, (@<)/2, (@>)/2, (@=<)/2, (@>=)/2, (=@=)/2, (\=@=)/2, compare/3,
           (?=)/2, unify_with_occurs_check/2, unifiable/3, subsumes_term/2, term_subsumer/3, (is)/2, (=:=)/2, (=\=)/2,
           (<)/2, (>)/2, (=<)/2, (>=)/2, succ/2, plus/3, between/3, var/1, nonvar/1, atom/1, number/1, integer/1,
           float/1, rational/1, rational/3, atomic/1, compound/1, callable/1, is_list/1, is_assoc/1, string/1, ground/1,
           nonground/2, cyclic_term/1, acyclic_term/1, functor/3, functor/4, arg/3, (=..)/2, compound_name_arity/3,
           compound_name_arguments/3, copy_term/2, copy_term_nat/2, duplicate_term/2, setarg/3, nb_setarg/3,
           term_variables/2, term_variables/3, term_singletons/2, numbervars/1, numbervars/3, term_hash/2,
           variant_hash/2, variant_sha1/2, length/2, sort/2, sort/4, msort/2, predsort/3, keysort/2, memberchk/2,
           atom_length/2, atom_concat/3, sub_atom/5, sub_atom_icasechk/3, atom_chars/2, atom_codes/2, atom_number/2,
           number_codes/2, number_chars/2, char_code/2, char_type/2, code_type/2, atomic_list_concat/2,
           atomic_list_concat/3, split_string/4, upcase_atom/2, downcase_atom/2, normalize_space/2, atom_string/2,
           number_string/2, string_chars/2, string_codes/2, string_code/3, sub_string/5, string_concat/3,
           string_length/2, string_lower/2, string_upper/2, text_concat/3, text_to_string/2, name/2, collation_key/2,
           write/1, writeln/1, writeq/1, print/1, nl/0, tab/1, put_char/1, write_canonical/1,
           portray_clause/1, current_op/3, current_predicate/1, tnot/1, undefined/0, abolish_all_tables/0,
           random/1, random_between/3, random_member/2, random_permutation/2, random_normal/3, holds/1, nb_current/2
         ]).
