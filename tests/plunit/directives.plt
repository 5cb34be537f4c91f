:- use_module('../../prolog/directives').

:- begin_tests(directives).

seen(Directive, Seen) :-
    catch(( directive(Directive, m, '/nowhere', _) -> Seen = changed ; Seen = same ), nppg_refused(_, _), Seen = refused).

test(declarations, all(Seen == [same, same, same, same])) :-
    member(Directive, [table(p/1), dynamic(p/1), op(700, xfx, ===>), use_module(library(dcg/basics))]),
    seen(Directive, Seen).
test(others, all(Seen == [refused, refused, refused, refused])) :-
    member(Directive, [shell(x), dynamic(user:p/1), op(700, xfx, user:(===>)), use_module(library(process))]),
    seen(Directive, Seen).

:- end_tests(directives).
