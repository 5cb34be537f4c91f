:- module(nppg_shapes,
          [ shapes/2             % +Module, -Shapes              det
          ]).

:- use_module(library(lists), [member/2, memberchk/2]).
:- use_module(guard).
:- use_module(loading, [defines/2]).

/** <module> States drawn as shapes

What a domain's shapes/1 gives, checked, as lists: its name, numbers, a tone, a text.

| box(X, Y, Width, Height, Tone, Text) | from the left lower corner    |
| disc(X, Y, Radius, Tone, Text)       | around its middle             |
| line(X1, Y1, X2, Y2, Tone)           |                               |
| text(X, Y, Text)                     | in the middle of this place   |

X grows to the right and Y upwards, in any unit. A tone is a name of tone/1, or a number from 1 to 6.
*/

%!  shapes(+Module, -Shapes) is det.
%
%   Of the current state; none where the domain defines no shapes/1.

shapes(Module, Shapes) :-
    (   \+ defines(Module, shapes/1)
    ->  Shapes = []
    ;   guarded(Module:(shapes/1), Module:shapes(Drawn)), is_list(Drawn)
    ->  findall(Shape, ( member(Each, Drawn), checked(Module, Each, Shape) ), Shapes)
    ;   fault(Module:(shapes/1), 'gave no list of shapes'-[])
    ).

checked(Module, Each, Shape) :-
    (   ground(Each), acyclic_term(Each), shape(Each, Shape)
    ->  true
    ;   fault(Module:(shapes/1), 'gave ~p, which is no shape'-[Each])
    ).

shape(box(X, Y, Width, Height, Tone, Text), [box, X, Y, Width, Height, Tone, Atom]) :-
    places([X, Y, Width, Height]),
    Width >= 0,
    Height >= 0,
    tone(Tone),
    told(Text, Atom).
shape(disc(X, Y, Radius, Tone, Text), [disc, X, Y, Radius, Tone, Atom]) :-
    places([X, Y, Radius]),
    Radius >= 0,
    tone(Tone),
    told(Text, Atom).
shape(line(X1, Y1, X2, Y2, Tone), [line, X1, Y1, X2, Y2, Tone]) :-
    places([X1, Y1, X2, Y2]),
    tone(Tone).
shape(text(X, Y, Text), [text, X, Y, Atom]) :-
    places([X, Y]),
    told(Text, Atom).

places(Numbers) :-
    \+ ( member(Number, Numbers), \+ ( number(Number), abs(Number) < 1.0e6 ) ).

tone(Tone) :-
    (   integer(Tone)
    ->  Tone >= 1,
        Tone =< 6
    ;   memberchk(Tone, [object, wanted, agent, place, wall, danger, faint])
    ).

told(Text, Atom) :-
    format(atom(Atom), '~w', [Text]).
